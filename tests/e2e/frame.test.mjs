// The frame: panels that are moved, folded and chosen, shortcuts, and what the status line says; for everyone.

import assert from "node:assert/strict";
import { siteTest } from "./harness.mjs";
import { accessible, eventually, printed, printedEnd } from "./steps.mjs";

const SIZES = {
  wide: { width: 1440, height: 900 },
  low: { width: 1024, height: 768 },
  phone: { width: 390, height: 844 },
};

/** The width or height of a panel. */
async function size(page, panel, dimension) {
  const box = await page.locator(`.${panel}-cell`).boundingBox();
  return box[dimension];
}

/** Holds that nothing is wider than the page. */
async function fits(page) {
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.equal(overflow, 0);
}

for (const [name, viewport] of Object.entries(SIZES)) {
  for (const colorScheme of ["light", "dark"]) {
    siteTest(`the page is for everyone, ${name} and ${colorScheme}`, async (page, { shot }) => {
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      await printedEnd(page, ">");
      await page.getByText("press Run").waitFor();
      await accessible(page);
      await shot(`frame-first-${name}-${colorScheme}`);
      await page.getByRole("button", { name: "Run", exact: true }).click();
      await page.getByText("press Run").waitFor({ state: "detached" });
      await accessible(page);
      await page.getByRole("button", { name: "Help" }).click();
      await page.getByRole("dialog", { name: "Help" }).waitFor();
      await accessible(page);
      await shot(`frame-help-${name}-${colorScheme}`);
      await page.keyboard.press("Escape");
      for (const dialog of ["Line settings", "Send file"]) {
        await page.getByRole("button", { name: dialog }).click();
        await page.getByRole("dialog").waitFor();
        await accessible(page);
        await shot(`frame-${dialog.replace(" ", "-").toLowerCase()}-${name}-${colorScheme}`);
        await page.keyboard.press("Escape");
      }
      await page.waitForTimeout(500);
      await shot(`frame-running-${name}-${colorScheme}`);
      await fits(page);
    });

    siteTest(`what goes wrong is said, ${name} and ${colorScheme}`, async (page, { shot }) => {
      await page.setViewportSize(viewport);
      await page.emulateMedia({ colorScheme });
      const look = async (state) => {
        await accessible(page);
        await fits(page);
        await shot(`frame-${state}-${name}-${colorScheme}`);
      };
      await printedEnd(page, ">");
      const emergency = page.getByRole("button", { name: "E-STOP" });
      await page.getByRole("button", { name: "Run", exact: true }).click();
      await page.getByText("press Run").waitFor({ state: "detached" });
      await emergency.click();
      await page.getByText("Emergency stop.").waitFor();
      await look("estop");
      await emergency.click();
      await page.getByText("Emergency stop.").waitFor({ state: "detached" });
      await page.getByRole("button", { name: "Stop", exact: true }).click();
      await printedEnd(page, "\n>");
      await page.getByRole("textbox", { name: "Terminal" }).focus();
      await page.keyboard.type("NEW\n10 GOTO 45\nRUN\n");
      await printedEnd(page, "?UNDEF'D STATEMENT ERROR IN 10\n>");
      await look("error");
      // The controller is asked twice a second what it holds.
      await page.waitForTimeout(1500);
      await page.workers()[0].evaluate(() => self.close()).catch(() => {});
      await page.getByText("The simulator has failed and was started again.").waitFor();
      await page.getByText("idle", { exact: true }).waitFor();
      await page.getByText("controller differs", { exact: true }).waitFor({ state: "attached" });
      assert.doesNotMatch(await printed(page), />>/, "the prompt is on a line of its own");
      await look("restarted");
      await page.getByRole("textbox", { name: "Terminal" }).focus();
      await page.keyboard.type("LIST\n");
      await printedEnd(page, "10 GOTO 45\n>");
    });
  }
}

siteTest("one press of Run moves the axis", async (page) => {
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.getByText("running", { exact: true }).waitFor();
  await page.getByText("press Run").waitFor({ state: "detached" });
  await printedEnd(page, "BACK 0\n>");
});

siteTest("dividers are dragged, moved by keys and put back; panels fold", async (page, { shot }) => {
  await printedEnd(page, ">");
  const columns = page.getByRole("separator", { name: "Width of the program" });
  const rows = page.getByRole("separator", { name: "Height of the terminal" });
  const before = await size(page, "program", "width");
  const box = await columns.boundingBox();
  await page.mouse.move(box.x + 4, box.y + 100);
  await page.mouse.down();
  await page.mouse.move(box.x + 204, box.y + 100, { steps: 5 });
  await page.mouse.up();
  assert.ok(Math.abs((await size(page, "program", "width")) - before - 200) < 8, "it follows the mouse");
  await columns.focus();
  await page.keyboard.press("Home");
  assert.equal(await columns.getAttribute("aria-valuenow"), "20");
  await page.keyboard.press("ArrowRight");
  assert.equal(await columns.getAttribute("aria-valuenow"), "22");
  await columns.dblclick();
  assert.ok(Math.abs((await size(page, "program", "width")) - before) < 1, "a double click puts it back");

  const scope = await size(page, "scope", "height");
  await rows.focus();
  await page.keyboard.press("ArrowUp");
  assert.ok((await size(page, "scope", "height")) > scope);
  await page.getByRole("button", { name: "Fold Scope" }).click();
  assert.ok((await size(page, "scope", "height")) < 40);
  await page.getByRole("button", { name: "Fold Terminal" }).click();
  assert.ok((await size(page, "scope", "height")) > scope, "what is left has the room");
  await page.getByRole("button", { name: "Fold Program" }).click();
  assert.ok((await size(page, "program", "width")) < 40);
  await accessible(page);
  await shot("folded");
  await page.getByRole("button", { name: "Show Program" }).click();
  await page.getByRole("button", { name: "Show Terminal" }).click();
  assert.ok(Math.abs((await size(page, "program", "width")) - before) < 1);
  // Nothing has been lost meanwhile.
  await page.locator(".screen").click();
  await page.keyboard.type("?1\n");
  await printedEnd(page, ">?1\n 1\n>");
});

siteTest("on a phone one panel is shown, and Run shows what it does", async (page, { shot }) => {
  await page.setViewportSize(SIZES.phone);
  await printedEnd(page, ">");
  await page.getByRole("button", { name: "Program", exact: true }).click();
  const line = page.getByLabel("A line for the controller");
  assert.ok(!(await line.isVisible()));
  await shot("phone-program");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await line.waitFor();
  await page.getByText("press Run").waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Scope", exact: true }).click();
  assert.ok(!(await line.isVisible()));
  await page.getByRole("switch", { name: "Input 0" }).waitFor();
  await shot("phone-scope");
});

siteTest("keys run, stop, pause and step, wherever the keyboard is", async (page, { shot }) => {
  await printedEnd(page, ">");
  await page.keyboard.type("10 A=1\n20 A=2\n30 GOTO 10\nRUN\n");
  await page.getByText("running", { exact: true }).waitFor();
  const time = () => page.locator(".status .time").textContent();
  await page.keyboard.press("F2");
  await page.getByText("simulated time stands still").first().waitFor();
  await page.getByText("paused", { exact: true }).waitFor();
  const stands = await time();
  await page.waitForTimeout(300);
  assert.equal(await time(), stands, "nothing passes");
  await shot("paused");
  const line = () => page.locator(".status .line").textContent();
  await page.keyboard.press("F10");
  await page.getByText("held before its next statement").waitFor();
  for (let step = 0; step < 4; step += 1) {
    const before = await line();
    await page.keyboard.press("F10");
    await eventually(`a step leads on from ${before}`, async () => (await line()) !== before || before);
  }
  await page.getByRole("button", { name: "Continue" }).click();
  await page.getByText("running", { exact: true }).waitFor();
  await page.keyboard.press("Shift+F5");
  await page.getByText("idle", { exact: true }).waitFor();
  await printedEnd(page, "\n>");
  assert.match(await printed(page), /BREAK IN [123]0\n>$/);
  await page.keyboard.press("F5");
  await page.getByText("Which one shall run?").waitFor();
  await page.getByRole("button", { name: "Send and run" }).click();
  await page.getByText("running", { exact: true }).waitFor();
});

siteTest("one thing has the keyboard, and the status line says which", async (page) => {
  await page.getByText("keyboard: terminal").waitFor();
  await page.getByRole("textbox", { name: "Program" }).click();
  await page.getByText("keyboard: editor").waitFor();
  // A press of the mouse on a button leaves it there.
  await page.getByRole("button", { name: "Pause" }).click();
  await page.getByText("keyboard: editor").waitFor();
  await page.locator(".screen").click();
  await page.getByText("keyboard: terminal").waitFor();
  await page.getByRole("combobox", { name: "Simulation speed" }).focus();
  await page.getByText("keyboard: page").waitFor();
});
