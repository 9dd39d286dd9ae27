// The scope, the axis, inputs and outputs, and the emergency stop, as a person works them.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { siteTest } from "./harness.mjs";
import { busy } from "./measures.mjs";
import { eventually } from "./steps.mjs";

const SPIN = ["10 MDRVEN()", "20 MSPEED(34952)", "30 GOTO 30", "RUN"];
const MOVE = ["10 MDRVEN()", "20 MMOVE(40960)", "RUN"];

/** Types lines into the terminal once it has a prompt. */
async function type(page, lines) {
  await printed(page, />$/);
  await page.getByRole("textbox", { name: /terminal/i }).first().focus();
  await page.keyboard.type(`${lines.join("\n")}\n`);
}

/** Waits until the terminal's text matches. */
function printed(page, pattern) {
  return eventually(`the terminal has ${pattern}`, async () => {
    const rows = await page.locator(".row").allTextContents();
    const text = rows.map((row) => row.trimEnd()).join("\n").trimEnd();
    return pattern.test(text) || text.slice(-200);
  });
}

/** The strip called `name`. */
function strip(page, name) {
  return page.locator(".strip", { has: page.getByRole("button", { name, exact: true }) });
}

/** The number that `locator` shows. */
async function number(locator) {
  const text = await locator.textContent();
  return Number(text.replaceAll(/[\u202f\s]/g, "").replace("\u2212", "-").replace(/[^-\d.].*$/, ""));
}

/** Moves the axis to 40960 and waits until it is there. */
async function move(page) {
  await type(page, MOVE);
  await eventually("the axis is at 40960", async () => (await number(strip(page, "position").locator(".value"))) === 40_960);
}

/** Adds signals to the picture, or takes them away. */
async function trace(page, ...names) {
  await page.getByRole("button", { name: "Traces" }).click();
  for (const name of names) {
    await page.getByRole("checkbox", { name, exact: true }).click();
  }
  await page.keyboard.press("Escape");
}

/** Starts an export, and gives the file. */
async function exported(page, name) {
  await page.getByRole("button", { name: "Export" }).click();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.getByRole("button", { name }).click(),
  ]);
  await page.keyboard.press("Escape");
  return { name: download.suggestedFilename(), contents: readFileSync(await download.path()) };
}

siteTest("traces are chosen after they were recorded, and exported as numbers and as a picture", async (page, { shot }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await move(page);
  assert.deepEqual(await page.locator(".strip-menu").allTextContents(), ["position", "velocity", "following error"]);
  await trace(page, "acceleration", "position, actual", "following error");
  assert.deepEqual(await page.locator(".strip-menu").allTextContents(), ["position", "velocity", "acceleration"]);
  const csv = await exported(page, "Numbers, CSV");
  assert.equal(csv.name, "motionbench-scope.csv");
  const rows = csv.contents.toString().trimEnd().split("\r\n").map((row) => row.split(","));
  assert.deepEqual(rows[0], [
    "time (s)", "x.command (counts)", "x.velocity (counts*256/sample)", "x.acceleration (counts*256/sample^2)",
  ]);
  assert.ok(rows.length > 500 && rows.every((row) => row.length === 4), `${rows.length} rows`);
  assert.equal(rows.at(-1)[1], "40960");
  assert.ok(Math.abs(rows[2][0] - rows[1][0] - 0.002) < 1e-9, "a sample every 2 ms");
  const png = await exported(page, "Picture, PNG");
  assert.equal(png.name, "motionbench-scope.png");
  assert.equal(png.contents.subarray(1, 4).toString(), "PNG");
  assert.ok(png.contents.length > 5000);
  await shot("scope-traces");
});

siteTest("cursors read values, differences and slope, by mouse and keys", async (page, { shot }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await move(page);
  await page.getByRole("button", { name: "Cursors" }).click();
  const [a, b] = [page.getByRole("slider", { name: "Cursor A" }), page.getByRole("slider", { name: "Cursor B" })];
  const over = await page.locator(".plots").boundingBox();
  const grip = await b.boundingBox();
  await page.mouse.move(grip.x + grip.width / 2, grip.y + 20);
  await page.mouse.down();
  await page.mouse.move(over.x + over.width - 1, grip.y + 20, { steps: 5 });
  await page.mouse.up();
  await a.press("Home");
  assert.equal(Number(await a.getAttribute("aria-valuenow")), 0);
  const at = Number(await b.getAttribute("aria-valuenow"));
  assert.match(await b.getAttribute("aria-valuetext"), /position demanded 40.960 counts/);
  const readings = strip(page, "position").locator(".readings p").first().locator("span:not(.key)");
  const cells = (await readings.allTextContents()).map((text) => text.replaceAll(/[\u202f\s]/g, ""));
  assert.deepEqual(cells.slice(0, 3), ["A0", "B40960", "\u039440960"]);
  assert.ok(Math.abs(Number(cells[3].replace("/s", "")) - 40_960 / at) < 1, `${cells[3]} at ${at}`);
  assert.match(await page.locator(".between").textContent(), new RegExp(`${at.toFixed(3)} s`));
  await a.press("ArrowRight");
  const one = Number(await a.getAttribute("aria-valuenow"));
  await a.press("Shift+ArrowRight");
  const eleven = Number(await a.getAttribute("aria-valuenow"));
  assert.ok(one > 0 && eleven > one * 5, `${one} then ${eleven}`);
  await shot("scope-cursors");
});

siteTest("zoom, pan, hold and follow change the picture, never the machine", async (page) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await type(page, SPIN);
  const position = strip(page, "position").locator(".value");
  await eventually("the axis turns", async () => (await number(position)) > 4096);
  await page.getByRole("button", { name: "Hold" }).click();
  await page.waitForTimeout(300);
  const held = await number(position);
  const track = await number(page.locator(".axis-strip .position"));
  await page.waitForTimeout(500);
  assert.equal(await number(position), held);
  assert.ok((await number(page.locator(".axis-strip .position"))) > track, "the axis goes on, and is seen to");
  await page.getByRole("button", { name: "Hold" }).click();
  await eventually("the values go on", async () => (await number(position)) > held);
  const shows = page.getByRole("combobox", { name: "What the picture shows" });
  assert.equal(await shows.inputValue(), "motion");
  await page.locator(".plots").hover();
  await page.mouse.wheel(0, -300);
  assert.equal(await shows.inputValue(), "chosen");
  await page.getByRole("button", { name: "Follow the axis" }).click();
  assert.equal(await shows.inputValue(), "motion");
  await page.locator(".plots").focus();
  await page.keyboard.press("ArrowLeft");
  assert.equal(await shows.inputValue(), "chosen");
  await page.keyboard.press("End");
  assert.equal(await shows.inputValue(), "newest");
  await page.keyboard.press("Home");
  assert.equal(await shows.inputValue(), "motion");
});

siteTest("a strip keeps a fixed scale, folds and goes", async (page) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await move(page);
  await page.getByRole("button", { name: "velocity", exact: true }).click();
  await page.getByRole("button", { name: "Fixed" }).click();
  await page.getByLabel("to", { exact: true }).fill("123000");
  await page.keyboard.press("Tab");
  assert.equal(await page.getByRole("button", { name: "Fixed" }).getAttribute("aria-pressed"), "true");
  assert.equal(await page.getByLabel("to", { exact: true }).inputValue(), "123000");
  await page.getByRole("button", { name: "Fold", exact: true }).click();
  await strip(page, "velocity").locator("canvas").waitFor({ state: "hidden" });
  await page.getByRole("button", { name: "Unfold", exact: true }).click();
  await strip(page, "velocity").locator("canvas").waitFor();
  await page.getByRole("button", { name: "Remove", exact: true }).click();
  assert.equal(await strip(page, "velocity").count(), 0);
});

siteTest("a switch is what the program reads, a lamp is what it writes", async (page, { shot }) => {
  await type(page, ["PRINT GV_IN3%;GV_IN12%"]);
  await printed(page, /\n 0 {1,2}1\n>$/);
  const input = page.getByRole("switch", { name: "Input 3" });
  await input.focus();
  await page.keyboard.press("Space");
  assert.equal(await input.getAttribute("aria-checked"), "true");
  await page.getByRole("switch", { name: /ENABLE/ }).click();
  await page.getByText("disabled, ENABLE is off").waitFor();
  await type(page, ["PRINT GV_IN3%;GV_IN12%"]);
  await printed(page, /\n 1 {1,2}0\n>$/);
  await type(page, ["GV_OUT7%=1"]);
  await page.getByText("output 7 on").waitFor({ state: "attached" });
  await page.getByText("output 6 off").waitFor({ state: "attached" });
  await shot("io");
});

for (const [size, viewport] of Object.entries({ wide: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } })) {
  for (const colorScheme of ["light", "dark"]) {
    siteTest(`E-STOP stops a running axis under any program and stays, ${size} and ${colorScheme}`, async (page, { shot }) => {
      await page.setViewportSize({ width: 1440, height: 900 });
      await page.emulateMedia({ colorScheme });
      await type(page, SPIN);
      const velocity = strip(page, "velocity").locator(".value");
      await eventually("the axis turns", async () => (await number(velocity)) > 30_000);
      await page.getByText("enabled", { exact: true }).waitFor();
      await page.setViewportSize(viewport);
      await shot(`turning-${size}-${colorScheme}`);
      await page.getByRole("button", { name: "E-STOP", exact: true }).click();
      await page.getByText("Emergency stop.").waitFor();
      await page.setViewportSize({ width: 1440, height: 900 });
      await eventually("the axis stands", async () => (await number(velocity)) === 0);
      await page.getByText("running", { exact: true }).waitFor();
      await page.setViewportSize(viewport);
      await page.waitForTimeout(300);
      await shot(`estop-${size}-${colorScheme}`);
      await page.getByRole("button", { name: "Release E-STOP" }).click();
      await page.getByText("Emergency stop.").waitFor({ state: "detached" });
      await page.setViewportSize({ width: 1440, height: 900 });
      await page.waitForTimeout(300);
      assert.equal(await number(velocity), 0, "released is not started");
    });
  }
}

siteTest("eight live traces are drawn within 4 ms a frame", async (page, { shot }) => {
  await page.setViewportSize({ width: 1440, height: 1500 });
  await type(page, SPIN);
  await trace(page, "velocity, actual", "acceleration", "torque", "motor shaft");
  await page.getByRole("combobox", { name: "What the picture shows" }).selectOption("newest");
  await page.waitForTimeout(1000);
  const { drawing, frames } = await busy(page, ({ drawing }) => drawing <= 4);
  await shot("eight-traces");
  assert.ok(frames > 20, `${frames} frames in 2 s`);
  assert.ok(drawing <= 4, `${drawing} ms`);
});

siteTest("E-STOP is in its corner at every size, pressed or not", async (page) => {
  for (const viewport of [{ width: 1440, height: 900 }, { width: 1024, height: 768 }, { width: 390, height: 844 }]) {
    await page.setViewportSize(viewport);
    const boxes = [];
    for (const name of ["E-STOP", "Release E-STOP"]) {
      const button = page.getByRole("button", { name, exact: true });
      boxes.push(await button.boundingBox());
      await button.click();
    }
    assert.deepEqual(boxes[0], boxes[1], "it does not move");
    const { x, y, width, height } = boxes[0];
    assert.ok(y < 16 && viewport.width - x - width < 16, `${x}, ${y} at ${viewport.width}`);
    assert.ok(viewport.width > 700 || height >= 44, `${height} high`);
  }
});
