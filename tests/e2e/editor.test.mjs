// A person at the editor: writes a program with its help, runs it, holds it at a line, and keeps it apart from the one
// in the controller.

import assert from "node:assert/strict";
import { siteTest } from "./harness.mjs";
import { programText, writeProgram } from "./steps.mjs";

/** The text field of the program, once the controller has answered. */
async function program(page) {
  await agreement(page, "not in the controller");
  return page.getByRole("textbox", { name: "Program" });
}

/** Waits until the editor says how its program stands to the controller's. */
async function agreement(page, words) {
  await page.locator(".editor .panel-head").getByText(words, { exact: true }).waitFor();
}

/** The line that runs, once it is `line`. */
async function runs(page, line) {
  await page.locator(".cm-line.running", { hasText: line }).waitFor();
}

const problem = (page) => page.getByRole("group", { name: "Problems" });

siteTest("the first program moves the axis with one press", async (page, { shot }) => {
  const editor = await program(page);
  assert.match(await programText(page), /^10 REM/);
  await shot("editor-first-visit");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await agreement(page, "same as in the controller");
  await runs(page, "120 IF");
  await shot("editor-running");
  await page.getByText("idle", { exact: true }).waitFor();
  assert.equal(await page.locator(".cm-line.running").count(), 0);
  await page.locator(".row", { hasText: "BACK 0" }).first().waitFor();
});

siteTest("a mistake is told in the device's words, and cured by a press", async (page, { shot }) => {
  const editor = await program(page);
  await writeProgram(page, "10 A=1\n40 PRINT A\n50 GOTO 45\nPRINT 2");
  const told = problem(page);
  await told.getByText("?SYNTAX ERROR").waitFor();
  await told.getByText("2 of 2").waitFor();
  await told.getByRole("button", { name: "Number it 60" }).click();
  await told.getByText("There is no line 45.").waitFor();
  await shot("editor-problem");
  await told.getByRole("button", { name: "Go to line 40" }).click();
  await page.getByText("No problems").waitFor();
  assert.equal(await programText(page), "10 A=1\n40 PRINT A\n50 GOTO 40\n60 PRINT 2");
  await page.keyboard.press("Control+z");
  await told.getByText("There is no line 45.").waitFor();
});

siteTest("a text that the controller refuses is said, and nothing is lost", async (page) => {
  const editor = await program(page);
  await writeProgram(page, "PRINT 2");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.getByRole("alert").getByText("The controller did not take the program").waitFor();
  assert.equal(await programText(page), "PRINT 2");
});

siteTest("words are completed and explained; Enter and Tab stay what they are", async (page) => {
  const editor = await program(page);
  await writeProgram(page, "10 FOR NE=1 TO 2\n");
  // Enter ends the line although the list offers NEXT and NEW.
  await page.keyboard.type("20 NEXT NE");
  await page.getByRole("listbox").waitFor();
  await page.keyboard.press("Enter");
  await page.keyboard.type("30 mmo");
  await page.getByRole("option", { name: "MMOVE" }).waitFor();
  await page.keyboard.press("Tab");
  assert.equal(await programText(page), "10 FOR NE=1 TO 2\n20 NEXT NE\n30 MMOVE");
  await page.keyboard.press("F1");
  await page.getByText("Moves to a position in counts.").waitFor();
  await page.keyboard.press("Escape");
  assert.equal(await page.getByText("Moves to a position in counts.").count(), 0);
  // With no list open, Tab leads out.
  await page.keyboard.press("Tab");
  assert.notEqual(await page.evaluate(() => document.activeElement.tagName), "PROGRAM-EDITOR");
});

siteTest("a breakpoint holds the program, and goes where its line goes", async (page, { shot }) => {
  const editor = await program(page);
  await writeProgram(page, "10 A=1\n20 A=A+1\n30 GOTO 20");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("F9");
  await page.locator(".breakpoint").waitFor();
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("5 REM FIRST\n");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.getByText("paused", { exact: true }).waitFor();
  await runs(page, "20 A=A+1");
  // The text changes under a program that is held: the line stays marked, and the page says so.
  await page.keyboard.type("6 REM SECOND\n");
  await runs(page, "20 A=A+1");
  await agreement(page, "changed since it was loaded");
  await shot("editor-held");
  await page.getByRole("button", { name: "Stop", exact: true }).click();
  await page.locator(".row", { hasText: /^BREAK IN 20/ }).waitFor();
  await page.getByText("idle", { exact: true }).waitFor();
});

siteTest("neither program replaces the other unasked", async (page, { shot }) => {
  const editor = await program(page);
  await writeProgram(page, "10 PRINT \"OURS\"");
  await page.locator(".screen").click();
  await page.keyboard.type("10 print \"theirs\"\n");
  await agreement(page, "controller differs");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.getByRole("alert").getByText("Which one shall run?").waitFor();
  await page.getByRole("button", { name: "Compare" }).click();
  await page.getByRole("cell", { name: "10 PRINT \"theirs\"" }).waitFor();
  await shot("editor-two-programs");
  await page.getByRole("button", { name: "Take" }).click();
  await agreement(page, "same as in the controller");
  assert.equal((await programText(page)).trim(), "10 PRINT \"theirs\"");
  // Undo brings ours back; now it may replace what was taken from there.
  await editor.click();
  await page.keyboard.press("Control+z");
  assert.equal(await programText(page), "10 PRINT \"OURS\"");
  await page.getByRole("button", { name: "Run", exact: true }).click();
  await page.locator(".row", { hasText: /^OURS/ }).waitFor();
});
