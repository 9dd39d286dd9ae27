// The front panel of a controller that is a device of its own, under mouse, fingers and keyboard.

import assert from "node:assert/strict";
import { siteTest } from "./harness.mjs";
import { accessible, eventually, printedEnd } from "./steps.mjs";

/** Puts the Unidex on the bench. */
async function unidex(page) {
  const choice = page.locator("select.controller").first();
  await choice.waitFor({ state: "attached" });
  await choice.evaluate((select) => {
    select.value = "unidex3";
    select.dispatchEvent(new Event("change", { bubbles: true }));
  });
  await page.locator(".device").waitFor();
  await shows(page, "URAM CLR");
  await page.locator(".status").getByText("idle", { exact: true }).waitFor();
}

/** What the text display shows. */
async function display(page) {
  const text = await page.locator(".stand").getByText(/^Display: /).textContent();
  return text.replace("Display: ", "");
}

/** Waits until the text display shows `text`. */
function shows(page, text) {
  return eventually(`the display shows ${text}`, async () => {
    const shown = await display(page);
    return shown === text || shown;
  });
}

/** The number of a tracking display. */
async function tracking(page, axis) {
  const text = await page.getByRole("list", { name: "Tracking displays" }).getByText(new RegExp(`^${axis} `)).textContent();
  return Number(text.slice(2));
}

/** The key that bears `legend`, shifted or not. */
async function key(page, legend) {
  const labels = await page.locator(".cap").evaluateAll((caps) => caps.map((cap) => cap.getAttribute("aria-label")));
  const bears = (label) =>
    label.split(", with SHIFT ").some((part) => part === legend || part.endsWith(` ${legend}`) || (legend.length > 1 && part.startsWith(`${legend} `)));
  const place = labels.findIndex(bears);
  assert.ok(place >= 0, `a key bears ${legend}`);
  return page.locator(".cap").nth(place);
}

async function press(page, keys) {
  for (const legend of keys.split(" ")) {
    await (await key(page, legend)).click();
  }
}

/** Waits until an axis has moved on by itself. */
function runs(page, axis) {
  return eventually(`${axis} runs`, async () => {
    const before = await tracking(page, axis);
    await page.waitForTimeout(100);
    return (await tracking(page, axis)) !== before || before;
  });
}

/** Waits until an axis stands. */
function stands(page, axis) {
  return eventually(`${axis} stands`, async () => {
    const before = await tracking(page, axis);
    await page.waitForTimeout(300);
    return (await tracking(page, axis)) === before || before;
  });
}

const leds = (page) => page.getByRole("list", { name: "LEDs" });

siteTest("a newcomer enters a square by the keys that the panel names, and runs it", async (page, { shot }) => {
  await unidex(page);
  await page.getByRole("button", { name: "First steps" }).click();
  const steps = await page
    .locator(".panel-steps li")
    .evaluateAll((rows) => rows.map((row) => [...row.querySelectorAll("kbd")].map((kbd) => kbd.textContent).join(" ")));
  assert.ok(steps.length > 5, "there are steps");
  for (const step of steps.slice(0, -1)) {
    await press(page, step);
  }
  await leds(page).getByText("EDIT on").waitFor({ state: "attached" });
  await shot("panel-steps");
  await press(page, steps.at(-1));
  await shows(page, "RUNNING");
  await page.getByText("axis moves", { exact: true }).waitFor();
  let farthest = [0, 0];
  await eventually("it is at its end", async () => {
    const at = [await tracking(page, "X"), await tracking(page, "Y")];
    farthest = farthest.map((far, axis) => Math.max(far, at[axis]));
    return (await display(page)) === "READY" || at;
  });
  assert.deepEqual(farthest, [1000, 1000]);
  await eventually("the square is closed", async () => (await tracking(page, "X")) === 0 && (await tracking(page, "Y")) === 0);
});

siteTest("Run and Stop act whoever has the unit", async (page) => {
  await unidex(page);
  await press(page, "SLW");
  await shows(page, "SLEW");
  // The panel has it now, and the console is not heard: the page presses RMT.
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await shows(page, "REMOTE");
  await runs(page, "X");
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await page.getByText("idle", { exact: true }).waitFor();
  await press(page, "RES");
  await shows(page, "SYS RDY");
  await page.keyboard.type("a");
  await page.keyboard.type("01\n");
  await shows(page, "RUNNING");
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await shows(page, "SYS RDY");
  await page.getByText("idle", { exact: true }).waitFor();
});

siteTest("an arrow key jogs while it is held, and lets go when the page loses it", async (page) => {
  await unidex(page);
  await press(page, "SLW");
  await shows(page, "SLEW");
  const right = await (await key(page, "\u25b6")).boundingBox();
  const hold = async () => {
    await page.mouse.move(right.x + right.width / 2, right.y + right.height / 2);
    await page.mouse.down();
    await runs(page, "X");
  };
  await hold();
  await page.mouse.up();
  await stands(page, "X");
  // Held, the finger slides off the key.
  await hold();
  await page.mouse.move(10, 300);
  await runs(page, "X");
  await page.mouse.up();
  await stands(page, "X");
  // The window goes to the back.
  await hold();
  await page.evaluate(() => window.dispatchEvent(new Event("blur")));
  await stands(page, "X");
  await page.mouse.up();
  // The page is hidden.
  await hold();
  await page.evaluate(() => {
    Object.defineProperty(document, "hidden", { value: true, configurable: true });
    document.dispatchEvent(new Event("visibilitychange", { bubbles: true }));
    delete document.hidden;
  });
  await stands(page, "X");
  await page.mouse.up();
  // On the keyboard: let go, and taken away.
  await page.getByRole("textbox", { name: "Front panel" }).focus();
  await page.keyboard.down("ArrowUp");
  await runs(page, "Y");
  await page.keyboard.up("ArrowUp");
  await stands(page, "Y");
  await page.keyboard.down("ArrowUp");
  await runs(page, "Y");
  await page.getByRole("button", { name: "Help" }).focus();
  await stands(page, "Y");
  await page.keyboard.up("ArrowUp");
});

siteTest("two fingers hold two keys", async (page) => {
  await unidex(page);
  await press(page, "SLW");
  const point = async (legend, id) => {
    const { x, y, width, height } = await (await key(page, legend)).boundingBox();
    return { x: x + width / 2, y: y + height / 2, id };
  };
  const [right, up] = [await point("\u25b6", 1), await point("\u25b2", 2)];
  const session = await page.context().newCDPSession(page);
  const touch = (type, touchPoints) => session.send("Input.dispatchTouchEvent", { type, touchPoints });
  await touch("touchStart", [right]);
  await touch("touchStart", [right, up]);
  await runs(page, "X");
  await runs(page, "Y");
  await touch("touchEnd", [right]);
  await stands(page, "X");
  await runs(page, "Y");
  await touch("touchEnd", []);
  await stands(page, "Y");
});

siteTest("what is typed presses the keys that bear it", async (page) => {
  await unidex(page);
  await page.getByRole("textbox", { name: "Front panel" }).focus();
  await page.keyboard.type("e25");
  await shows(page, "EDIT 25");
  await page.keyboard.press("Enter");
  await shows(page, ">>");
  await page.keyboard.type('g7x100"Hello 1');
  await shows(page, "\"HELLO 1");
  await leds(page).getByText("EDIT flashing").waitFor({ state: "attached" });
  await page.keyboard.press("Backspace");
  await shows(page, '0"HELLO');
  await page.keyboard.type('"');
  await leds(page).getByText("EDIT on").waitFor({ state: "attached" });
  await page.keyboard.press("Insert");
  await leds(page).getByText("SHIFT on").waitFor({ state: "attached" });
  await page.keyboard.press("End");
  await shows(page, "EDITING!");
  // A screen reader presses without a finger.
  await (await key(page, "EXC")).evaluate((button) => button.click());
  await shows(page, '"HELLO "');
});

siteTest("the terminal is the host and the printer, at the speed that the switches say", async (page, { shot }) => {
  await unidex(page);
  await page.getByRole("textbox", { name: "Front panel" }).focus();
  await page.keyboard.type("e02");
  await page.keyboard.press("Enter");
  await page.keyboard.type("g91*x100f500*m2*a");
  await press(page, "PRT 0 2 EXC");
  await shows(page, "READY");
  await page.getByRole("button", { name: "Printer" }).click();
  const paper = page.getByRole("region", { name: "Paper" });
  await paper.getByText("UNIDEX-III PROGRAM LISTING").waitFor();
  await paper.getByText("X100 F500").waitFor();
  await accessible(page);
  await shot("panel-printer");
  // The controller listens at another speed than the terminal.
  await page.getByRole("button", { name: "Rear", exact: true }).click();
  await page.getByRole("combobox", { name: "Baud rate" }).selectOption({ label: "1200" });
  await page.getByRole("switch", { name: "Device address, switch 7" }).click();
  await accessible(page);
  await shot("panel-rear");
  await page.getByRole("button", { name: "Set", exact: true }).click();
  await page.getByRole("button", { name: "Front", exact: true }).click();
  await shows(page, "SYS RDY");
  await page.getByRole("button", { name: "Terminal", exact: true }).click();
  const type = async (line) => {
    await page.getByRole("textbox", { name: "Terminal" }).focus();
    await page.keyboard.press("Escape");
    await page.keyboard.type(`${line}\n`);
  };
  await type("03");
  const other = page.locator(".status").getByText("the controller is set to 1200 8N1");
  await other.waitFor();
  await page.getByRole("button", { name: "Line settings" }).click();
  await page.getByRole("button", { name: "As the controller" }).click();
  await page.getByRole("button", { name: "Set", exact: true }).click();
  await other.waitFor({ state: "detached" });
  await type("03");
  await page.keyboard.type("PX\n");
  await printedEnd(page, "PX\nX0000000000");
  // All of it comes back.
  await page.waitForTimeout(1500);
  await page.reload();
  await page.getByRole("button", { name: "Panel", exact: true }).click();
  await page.getByRole("button", { name: "Rear", exact: true }).click();
  await eventually("the address is kept", async () => (await page.locator(".dips output").first().textContent()) === "3");
});

siteTest("a person talks to the bus", async (page, { shot }) => {
  await unidex(page);
  await page.getByRole("button", { name: "Bus", exact: true }).click();
  await page.getByRole("switch", { name: "REN" }).click();
  await page.getByRole("button", { name: "Listen", exact: true }).click();
  await page.getByRole("textbox", { name: "Data for the listeners" }).fill("I G91 X100 F500");
  await page.keyboard.press("Enter");
  await page.locator(".srq.on").waitFor();
  await page.getByRole("button", { name: "Parallel poll" }).click();
  const log = page.getByRole("log", { name: "What was asked of the bus" });
  await log.getByText("line 1 answers").waitFor();
  await page.getByRole("button", { name: "Serial poll" }).click();
  await log.getByText("unit 1: 40h").waitFor();
  await page.locator(".srq:not(.on)").waitFor();
  await accessible(page);
  await shot("panel-bus");
  await page.getByRole("textbox", { name: "Data for the listeners" }).fill("PX");
  await page.getByRole("button", { name: "Listen", exact: true }).click();
  await page.getByRole("button", { name: "Send", exact: true }).click();
  await page.getByRole("button", { name: "Talk", exact: true }).click();
  await log.getByText("X0000000100").waitFor();
});

siteTest("the joystick moves the axes in a slew, and springs back", async (page, { shot }) => {
  await unidex(page);
  await press(page, "SLW");
  await page.getByRole("button", { name: "Joystick", exact: true }).click();
  const base = await page.getByRole("group", { name: "Joystick" }).boundingBox();
  await page.mouse.move(base.x + base.width / 2, base.y + base.height / 2);
  await page.mouse.down();
  await page.mouse.move(base.x + base.width * 0.9, base.y + base.height * 0.2);
  await runs(page, "X");
  await runs(page, "Y");
  await shot("panel-joystick");
  await page.mouse.up();
  await stands(page, "X");
  await stands(page, "Y");
  await page.getByRole("group", { name: "Joystick" }).focus();
  await page.keyboard.down("ArrowLeft");
  await runs(page, "X");
  await page.getByRole("button", { name: "Help" }).focus();
  await stands(page, "X");
  await page.keyboard.up("ArrowLeft");
});

siteTest("keys are recorded as a scenario that presses them", async (page) => {
  await unidex(page);
  await page.getByRole("button", { name: "Record keys" }).click();
  await press(page, "SLW");
  await page.getByRole("textbox", { name: "Front panel" }).focus();
  await page.keyboard.down("ArrowRight");
  await runs(page, "X");
  await page.keyboard.up("ArrowRight");
  const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("button", { name: "Save 2 keys" }).click()]);
  const chunks = [];
  for await (const chunk of await download.createReadStream()) {
    chunks.push(chunk);
  }
  assert.match(Buffer.concat(chunks).toString(), /^bench unidex3\npower on\nrun until idle\n(run .*\n)?press SLW\nrun .*\nhold RIGHT [\d.]+s\n/);
});

/** One panel for `count` units. */
async function share(page, count) {
  const label = count === 1 ? "Fitted" : `One for ${count} units, with a selector`;
  await page.getByRole("button", { name: "Rear", exact: true }).click();
  await page.getByRole("combobox", { name: "Keyboard" }).selectOption({ label });
  await page.getByRole("button", { name: "Set", exact: true }).click();
  await page.getByRole("button", { name: "Front", exact: true }).click();
  await eventually("its places are there", async () => (await page.locator(".place").count()) === (count === 1 ? 0 : count));
  await shows(page, "URAM CLR");
}

const turn = (page, pair) => page.getByRole("button", { name: `Axis pair ${pair}`, exact: true }).click();

siteTest("one panel has several units, each with its axes, switches and programs", async (page, { shot }) => {
  await unidex(page);
  await share(page, 3);
  await turn(page, 2);
  await shows(page, "URAM CLR");
  await page.keyboard.type("e07\n");
  await page.keyboard.type("g91*x3000f300*m2*a");
  await page.getByRole("switch", { name: "Input C2" }).click();
  await press(page, "EXC");
  await shows(page, "RUNNING");
  // It runs on by itself while another is looked at.
  await turn(page, 1);
  await shows(page, "URAM CLR");
  assert.equal(await tracking(page, "X"), 0);
  assert.equal(await page.getByRole("switch", { name: "Input C2" }).getAttribute("aria-checked"), "true", "C2 of unit 1 is as it was");
  await press(page, "SLW");
  await page.keyboard.down("ArrowUp");
  await runs(page, "Y");
  await page.keyboard.up("ArrowUp");
  await turn(page, 2);
  await runs(page, "X");
  await accessible(page);
  await shot("panel-selector");
  await page.locator(".axis-strip .position").first().getByText(/^3,?.?000/).waitFor({ timeout: 20_000 });
  assert.equal(await tracking(page, "X"), 3000);
  assert.equal(await page.getByRole("switch", { name: "Input C2" }).getAttribute("aria-checked"), "false");
  // What each holds comes back, and each is addressed by itself.
  await page.waitForTimeout(1500);
  await page.reload();
  await page.getByRole("button", { name: "Terminal", exact: true }).click();
  await page.getByRole("textbox", { name: "Terminal" }).focus();
  await page.keyboard.press("Escape");
  await page.keyboard.type("02\nPD\n");
  await page.getByText("PROGRAM # 07").first().waitFor();
});

for (const [size, width, height] of [["phone", 360, 740], ["tablet", 820, 1180], ["wide", 1440, 900]]) {
  for (const colorScheme of ["light", "dark"]) {
    siteTest(`the panel is clear and usable, ${size} and ${colorScheme}`, async (page, { shot }) => {
      await page.setViewportSize({ width, height });
      await page.emulateMedia({ colorScheme });
      await unidex(page);
      await share(page, 8);
      await accessible(page);
      await shot(`panel-${size}-${colorScheme}-selector`);
      const places = await page.locator(".place").evaluateAll((places) => places.map((place) => place.getBoundingClientRect()));
      assert.ok(places.every((place) => Math.min(place.width, place.height) >= 24 && place.right <= width), "its places can be hit");
      await share(page, 1);
      const device = await page.locator(".device").boundingBox();
      assert.ok(device.x >= 0 && device.x + device.width <= width, "the device is in sight");
      const caps = await page.locator(".pad .cap").evaluateAll((caps) => caps.map((cap) => cap.getBoundingClientRect()));
      const smallest = Math.min(...caps.map((cap) => Math.min(cap.width, cap.height)));
      assert.ok(smallest >= (size === "phone" ? 44 : 24), `keys of ${smallest} pixels`);
      const before = JSON.stringify(device);
      await page.getByRole("textbox", { name: "Front panel" }).focus();
      await page.keyboard.type("e25\ng7x100f10000");
      await eventually("it is typed", async () => (await display(page)).endsWith("F10000"));
      assert.equal(JSON.stringify(await page.locator(".device").boundingBox()), before, "nothing moves");
      await shot(`panel-${size}-${colorScheme}`);
    });
  }
}
