// A newcomer, who knows nothing but what the page says.

import assert from "node:assert/strict";
import { siteTest } from "./harness.mjs";
import { busy, paints } from "./measures.mjs";
import { eventually, firstSteps, powerCycle, printed, printedEnd } from "./steps.mjs";

const position = (page) => page.locator(".strip-label", { hasText: "position" }).locator(".value").first();

/** Waits until the position is `value`. */
function stands(page, value) {
  return eventually(`the axis is at ${value}`, async () => {
    const text = (await position(page).textContent()).replaceAll("\u202f", "");
    return text === value || text;
  });
}

siteTest("from opening the page to an axis that moves it takes one press", async (page) => {
  const opened = performance.now();
  await page.reload();
  await page.getByText("Nothing has moved yet: press Run.").waitFor();
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.getByText("axis moves", { exact: true }).waitFor();
  const seconds = (performance.now() - opened) / 1000;
  console.log(`the axis moves ${seconds.toFixed(1)} s after the page was asked for`);
  assert.ok(seconds < 10, `${seconds} s`);
});

siteTest("what Help says leads to a program of one's own that outlives the power", async (page, { shot }) => {
  await printedEnd(page, ">");
  const steps = await firstSteps(page);
  assert.ok(steps.length > 5, "Help has steps");
  await page.getByRole("textbox", { name: "Terminal" }).focus();
  for (const { press, type } of steps) {
    if (press) {
      await powerCycle(page, press);
      await printedEnd(page, ">");
      await stands(page, "0");
      continue;
    }
    await page.keyboard.type(`${type}\n`);
    await eventually(`${type} is answered`, async () => {
      const text = await printed(page);
      return (text.includes(type) && text.endsWith(">")) || text.slice(-100);
    });
    assert.doesNotMatch(await printed(page), /ERROR/);
    if (type === "RUN") {
      await stands(page, "40960");
    }
  }
  assert.doesNotMatch(await printed(page), />>/, "after a power cycle the prompt is on a line of its own");
  await shot("newcomer");
});

siteTest("a busy program, a streaming terminal and four live traces leave time", async (page, { shot }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await printedEnd(page, ">");
  await page.keyboard.type("10 MDRVEN() : MSPEED(34952)\n20 PRINT \"POSITION\"; GV_FEEDBACK%\n30 GOTO 20\nRUN\n");
  await page.getByText("axis moves", { exact: true }).waitFor();
  await page.getByRole("combobox", { name: "What the picture shows" }).selectOption("newest");
  await page.waitForTimeout(2000);
  const early = await busy(page, () => true);
  // It has printed so long that the oldest lines are forgotten.
  const speed = page.getByRole("combobox", { name: "Simulation speed" });
  await speed.selectOption("max");
  const height = () => page.locator(".rows").evaluate((rows) => rows.getBoundingClientRect().height);
  await eventually("a thousand lines are there", async () => (await height()) > 20_000 || (await height()));
  await speed.selectOption({ label: "1×" });
  await page.waitForTimeout(2000);
  await paints(page, 55);
  // It costs no more than before: only what is on the screen is drawn.
  const isLittle = ({ all }) => all <= 8 && all <= 1.4 * early.all;
  const late = await busy(page, isLittle);
  await shot("busy-page");
  assert.ok(isLittle(late), `${late.all} ms of the main thread a frame, ${early.all} ms before`);
  // Whoever looks back sees all of it, and all is there when it is calm.
  const rows = () => page.locator(".row").count();
  await page.locator(".screen").hover();
  await page.mouse.wheel(0, -2000);
  await eventually("what was printed before is there", async () => (await rows()) > 1000 || (await rows()));
  await page.mouse.wheel(0, 3000);
  await eventually("the screen alone is drawn", async () => (await rows()) < 100 || (await rows()));
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await eventually("all rows are there", async () => (await rows()) > 1000 || (await rows()));
});
