// Another controller on the bench: it is chosen, worked with as it wants to be, and the work with each is kept.

import assert from "node:assert/strict";
import { siteTest } from "./harness.mjs";
import { accessible, eventually, firstSteps, powerCycle, printed, printedEnd, programText, writeProgram } from "./steps.mjs";

const choice = (page) => page.getByRole("combobox", { name: "Controller" }).first();

/** Puts another controller on the bench. */
async function choose(page, name) {
  await choice(page).selectOption({ label: name });
  await page.locator(".status").getByText("idle", { exact: true }).waitFor();
}

const position = (page) => page.locator(".strip-label", { hasText: "position" }).locator(".value").first();

for (const colorScheme of ["light", "dark"]) {
  siteTest(`a SmartMotor runs its first program and obeys its host, ${colorScheme}`, async (page, { shot }) => {
    await page.setViewportSize({ width: 1440, height: 900 });
    await page.emulateMedia({ colorScheme });
    await printedEnd(page, ">");
    await choose(page, "Animatics SmartMotor");
    await page.getByText("Nothing has moved yet").waitFor();
    assert.match(await programText(page), /^'TEN TURNS/);
    await page.getByText("No problems").waitFor();
    await accessible(page);
    await page.getByRole("button", { name: "Run", exact: true }).click();
    await page.getByText("axis moves", { exact: true }).waitFor();
    await page.locator(".cm-line.running").first().waitFor();
    await page.getByText("same as in the controller").waitFor();
    await page.waitForTimeout(1500);
    await shot(`smartmotor-${colorScheme}`);
    await eventually("it has said where it is", async () => {
      const shown = await printed(page);
      return /^RUN\nOUT 2000\d\nBACK /.test(shown) || shown;
    });
    await page.getByRole("button", { name: "Stop", exact: true }).click();
    await page.locator(".status").getByText("idle", { exact: true }).waitFor();
    // What is typed is shown, though the motor does not echo it.
    await page.getByRole("textbox", { name: "Terminal" }).focus();
    await page.keyboard.type("P=40000 G\n");
    await eventually("the motor is at 40000", async () => {
      const shown = (await position(page).textContent()).replaceAll("\u202f", "");
      return Math.abs(Number(shown) - 40_000) < 3 || shown;
    });
    assert.match(await printed(page), /P=40000 G$/);
    // A pin read as a voltage.
    await page.getByRole("button", { name: "Knobs" }).click();
    await page.getByRole("slider", { name: "Pin UF" }).fill("2.5");
    await accessible(page);
    await shot(`smartmotor-knobs-${colorScheme}`);
    await page.keyboard.press("Escape");
    await page.getByRole("textbox", { name: "Terminal" }).focus();
    await page.keyboard.type("RUFA\n");
    await printedEnd(page, "RUFA\n512");
  });
}

siteTest("on a phone the controller is chosen with the project", async (page, { shot }) => {
  await page.setViewportSize({ width: 390, height: 844 });
  await printedEnd(page, ">");
  await page.getByRole("button", { name: "My project" }).click();
  const dialog = page.getByRole("dialog", { name: "Project" });
  await dialog.getByRole("combobox", { name: "Controller" }).selectOption("smartmotor");
  await accessible(page);
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await eventually("the motor says where it is", async () => /OUT 2000\d/.test(await printed(page)) || printed(page));
  await page.getByRole("navigation").getByRole("button", { name: "Scope" }).click();
  await accessible(page);
  await shot("smartmotor-phone");
});

siteTest("what Help says of a SmartMotor works", async (page) => {
  await printedEnd(page, ">");
  await choose(page, "Animatics SmartMotor");
  const steps = await firstSteps(page);
  const status = page.locator(".status");
  for (const { press, type } of steps) {
    if (press) {
      await powerCycle(page, press);
      continue;
    }
    await page.getByRole("textbox", { name: "Terminal" }).focus();
    await page.keyboard.type(`${type}\n`);
    await page.waitForTimeout(100);
    await status.getByText("idle", { exact: true }).waitFor();
    await page.getByText("axis moves", { exact: true }).waitFor({ state: "detached" });
  }
  await printedEnd(page, `${steps.at(-1).type}\n7`);
  await page.keyboard.type("RBs\n");
  await printedEnd(page, "RBs\n0");
});

siteTest("the master's encoder is turned, and the cam is drawn with its place", async (page, { shot }) => {
  await page.setViewportSize({ width: 1440, height: 900 });
  await printedEnd(page, ">");
  const program = [
    "10 DIM T%(359) : FOR N=0 TO 359 : T%(N)=4096*SIN(N*3.14159/180) : NEXT",
    "20 GV_MMOD%=4096 : MDRVEN() : MCAMHARD(T%)",
    "RUN",
  ];
  await page.keyboard.type(`${program.join("\n")}\n`);
  await eventually("the program has ended", async () => /RUN\n>$/.test(await printed(page)) || printed(page));
  await page.getByRole("button", { name: "Knobs" }).click();
  await page.getByRole("slider", { name: "Master encoder" }).fill("120");
  await accessible(page);
  await shot("knobs");
  await page.keyboard.press("Escape");
  await page.getByText("axis moves", { exact: true }).waitFor();
  await page.getByRole("button", { name: "Cam", exact: true }).click();
  const curve = page.getByRole("img", { name: /360 points/ });
  await curve.waitFor();
  const place = () => page.locator(".cam .place").getAttribute("cx");
  const before = await place();
  await eventually("the place moves on", async () => (await place()) !== before || before);
  await accessible(page);
  await page.waitForTimeout(1000);
  await shot("cam");
});

siteTest("a program is sent to the controller without being started", async (page) => {
  await printedEnd(page, ">");
  await page.getByText("not in the controller").waitFor();
  await page.locator(".editor").getByRole("button", { name: "More" }).click();
  await page.getByRole("button", { name: "Send to the controller" }).click();
  await page.getByText("same as in the controller").waitFor();
  await page.getByRole("textbox", { name: "Terminal" }).focus();
  await page.keyboard.type("LIST 130\n");
  await printedEnd(page, ">LIST 130\n130 RETURN\n>");
});

siteTest("the work with each controller is kept", async (page) => {
  await printedEnd(page, ">");
  await page.keyboard.type("10 PRINT 6*7\nSAVE \"B:SEVEN\"\n");
  await printedEnd(page, ">SAVE \"B:SEVEN\"\n>");
  await writeProgram(page, "10 REM MINE");
  await choose(page, "Animatics SmartMotor");
  await eventually("its first program is there", async () => (await programText(page)).startsWith("'TEN"));
  await writeProgram(page, "a=42\nEPTR=0 VST(a,1)\nRa\nEND");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await printedEnd(page, "42");
  await page.waitForTimeout(1200);
  await page.reload();
  await eventually("the SmartMotor is on the bench again", async () => (await choice(page).inputValue()) === "smartmotor");
  await eventually("its program is there", async () => (await programText(page)).startsWith("a=42"));
  await page.getByText("same as in the controller").waitFor();
  await choose(page, "Danaher MC-600");
  await eventually("the other program is there", async () => (await programText(page)) === "10 REM MINE");
  await printedEnd(page, ">");
  await page.getByRole("textbox", { name: "Terminal" }).focus();
  await page.keyboard.type("RUN \"B:SEVEN\"\n");
  await printedEnd(page, "\n 42\n>");
  await choose(page, "Animatics SmartMotor");
  await page.getByRole("textbox", { name: "Terminal" }).focus();
  await page.keyboard.type("EPTR=0 VLD(b,1) Rb\n");
  await printedEnd(page, "\n42");
});
