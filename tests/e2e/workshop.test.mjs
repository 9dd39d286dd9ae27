// A person at the page: types a program, sees the axis move, stops a program that never ends.

import assert from "node:assert/strict";
import { siteTest } from "./harness.mjs";
import { paints } from "./measures.mjs";
import { eventually, paste, printed, printedEnd } from "./steps.mjs";

const PROGRAM = ["10 MDRVEN()", "20 MMOVE(40960)", "RUN"];
const SIZES = { wide: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } };

/** Waits until the strip called `label` shows `value`. */
function shows(page, label, value) {
  const strip = page.locator(".strip-label", { hasText: label }).locator(".value");
  return eventually(`${label} is ${value}`, async () => {
    const text = (await strip.textContent()).replaceAll("\u202f", " ");
    return text === value || text;
  });
}

/** How many pixels of the strip's canvas have the colour of its line. */
function linePixels(page, strip) {
  return page.evaluate((strip) => {
    const canvas = document.querySelectorAll(".strip-plot canvas")[strip];
    const token = getComputedStyle(document.documentElement).getPropertyValue(["--trace-1", "--trace-3"][strip]);
    const wanted = [1, 3, 5].map((at) => Number.parseInt(token.trim().slice(at, at + 2), 16));
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    let found = 0;
    for (let at = 0; at < data.length; at += 4) {
      found += wanted.every((value, channel) => Math.abs(data[at + channel] - value) < 8);
    }
    return found;
  }, strip);
}

for (const [size, viewport] of Object.entries(SIZES)) {
  for (const colorScheme of ["light", "dark"]) {
    siteTest(`a typed program moves the axis, ${size} and ${colorScheme}`, async (page, { shot }) => {
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      await printedEnd(page, ">");
      await page.getByText("keyboard: terminal").waitFor();
      await page.getByText("Nothing has moved yet").waitFor();
      await shot(`first-visit-${size}-${colorScheme}`);
      if (size === "phone") {
        for (const line of PROGRAM) {
          await page.getByLabel("A line for the controller").fill(line);
          await page.getByRole("button", { name: "Send", exact: true }).click();
        }
      } else {
        await page.keyboard.type(`${PROGRAM.join("\n")}\n`);
      }
      await page.getByText("Nothing has moved yet").waitFor({ state: "detached" });
      await page.waitForTimeout(700);
      await shot(`moving-${size}-${colorScheme}`);
      if (size === "phone") {
        await page.getByRole("navigation").getByRole("button", { name: "Scope" }).click();
      }
      await shows(page, "position", "40 960");
      await shows(page, "velocity", "0");
      await printedEnd(page, "\n>RUN\n>");
      assert.ok(await linePixels(page, 0) > 40, "the position is drawn");
      assert.ok(await linePixels(page, 1) > 40, "the velocity is drawn");
      await page.waitForTimeout(700);
      await shot(`moved-${size}-${colorScheme}`);
    });
  }
}

siteTest("a program that never ends leaves the page answering, and Ctrl-C ends it", async (page, { shot }) => {
  await printedEnd(page, ">");
  await page.keyboard.type("10 GOTO 10\nRUN\n");
  await page.getByText("line 10", { exact: true }).waitFor();
  await page.getByText("running", { exact: true }).waitFor();
  await paints(page, 55);
  await shot("busy");
  await page.keyboard.press("Control+c");
  await printedEnd(page, "BREAK IN 10\n>");
  await page.getByText("idle", { exact: true }).waitFor();
});

siteTest("Run and Stop act on the console, Power loses the program", async (page) => {
  await printedEnd(page, ">");
  await page.keyboard.type("10 GOTO 10\n");
  await page.getByText("controller differs").waitFor();
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.getByRole("button", { name: "Run the controller's" }).click();
  await page.getByText("running", { exact: true }).waitFor();
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await printedEnd(page, ">RUN\nBREAK IN 10\n>");
  // The mouse has left the keyboard where it was.
  await page.keyboard.type("?6*7\n");
  await printedEnd(page, ">?6*7\n 42\n>");
  const power = page.getByRole("switch", { name: "Power" });
  await power.click();
  await page.getByText("off", { exact: true }).last().waitFor();
  assert.equal(await power.getAttribute("aria-checked"), "false");
  assert.ok(await page.getByRole("button", { name: "Run" }).isDisabled());
  await power.click();
  await page.getByText("idle", { exact: true }).waitFor();
  await page.keyboard.type("LIST\n");
  await printedEnd(page, ">LIST\n>");
});

siteTest("a flood of text, a megabyte of paste and full speed leave the page answering", async (page, { shot }) => {
  await printedEnd(page, ">");
  await page.keyboard.type("10 PRINT \"ALL WORK AND NO PLAY\"\n20 GOTO 10\nRUN\n");
  await page.getByRole("combobox", { name: "Simulation speed" }).selectOption("max");
  await paste(page, "REM PASTED\n".repeat(100_000));
  await paints(page, 55);
  await shot("flood");
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await page.getByText("idle", { exact: true }).waitFor();
  await eventually("the program is stopped", async () => {
    const text = await printed(page);
    return /BREAK IN [12]0\n>$/.test(text) || text.slice(-200);
  });
});

siteTest("a screen reader hears what the controller prints", async (page) => {
  await printedEnd(page, ">");
  await page.keyboard.type("?\"HELLO\"\nINPUT \"LENGTH\";L\n");
  const log = page.getByRole("log");
  await log.getByText("HELLO", { exact: true }).waitFor();
  await log.getByText("LENGTH").last().waitFor();
});

siteTest("selected text is copied by Ctrl-C, and typing goes on after it", async (page) => {
  await printedEnd(page, ">");
  await page.keyboard.type("10 GOTO 10\nRUN\n");
  await page.getByText("running", { exact: true }).waitFor();
  await page.locator(".row", { hasText: "10 GOTO 10" }).click({ clickCount: 3 });
  await page.keyboard.press("Control+c");
  await page.waitForTimeout(300);
  assert.ok(!(await printed(page)).includes("BREAK"), "Ctrl-C copied");
  await page.keyboard.type("A");
  await page.getByText("keyboard: terminal").waitFor();
  await page.keyboard.press("Control+c");
  await printedEnd(page, "BREAK IN 10\n>");
});

siteTest("a worker of another build, or none, is said, with the cure", async (page, { forgive, shot }) => {
  // A reload while the files still arrive is an error of its own.
  await printedEnd(page, ">");
  const worker = /worker_loader\.js$/;
  await page.route(worker, (route) => route.fulfill({
    contentType: "text/javascript",
    body: 'postMessage(["{\\"Ready\\":{\\"build\\":\\"other\\"}}", new Float64Array(0)])',
  }));
  await page.reload();
  await page.getByRole("alert").getByText("newer version").waitFor();
  await shot("other-build");
  await page.unroute(worker);
  await page.getByRole("button", { name: "Reload" }).click();
  await printedEnd(page, ">");
  forgive(/worker_loader\.js/);
  forgive(/Failed to load resource/);
  await page.route(worker, (route) => route.abort());
  await page.reload();
  await page.getByRole("alert").getByText("could not be started").waitFor();
});
