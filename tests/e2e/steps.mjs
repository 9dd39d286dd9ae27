// What a person does at the page and sees there, for tests that say it in their own words.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Waits until `check` gives true. Playwright's own waitForFunction evaluates text, which the page's policy forbids. */
export async function eventually(what, check) {
  const look = async () => {
    try {
      return await check();
    } catch (error) {
      // The page that was looked at is being left.
      assert.match(error.message, /because of a navigation/, error);
      return error.message;
    }
  };
  const end = Date.now() + 20_000;
  let seen = await look();
  while (seen !== true) {
    assert.ok(Date.now() < end, `${what}; there was ${JSON.stringify(seen)}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
    seen = await look();
  }
}

/** What the terminal shows, without the empty rows at its end. */
export async function printed(page) {
  const rows = await page.locator(".row").allTextContents();
  return rows.map((row) => row.trimEnd()).join("\n").trimEnd();
}

/** Waits until the terminal's text ends with `end`. */
export function printedEnd(page, end) {
  return eventually(`the terminal's text ends with ${JSON.stringify(end)}`, async () => {
    const text = await printed(page);
    return text.endsWith(end) || text.slice(-200);
  });
}

/** The text in the editor. */
export async function programText(page) {
  const lines = await page.locator(".cm-line").allTextContents();
  return lines.join("\n");
}

/** Writes another program over the one in the editor. */
export async function writeProgram(page, text) {
  await page.getByRole("textbox", { name: "Program" }).click();
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(text);
}

/** The first steps as Help tells them: what to press, what to type. */
export async function firstSteps(page) {
  await page.getByRole("button", { name: "Help" }).click();
  const rows = page.getByRole("dialog", { name: "Help" }).locator(".steps-help li");
  const steps = await rows.evaluateAll((rows) =>
    rows.map((row) => ({ press: row.querySelector("strong")?.textContent, type: row.querySelector("code")?.textContent })),
  );
  await page.keyboard.press("Escape");
  return steps;
}

/** Switches a device off and on again, by the name of its switch. */
export async function powerCycle(page, name) {
  const button = page.getByRole("switch", { name });
  const status = page.locator(".status");
  await button.click();
  await status.getByText("off", { exact: true }).waitFor();
  await button.click();
  await status.getByText("idle", { exact: true }).waitFor();
}

/** Has the browser paste a text where the keyboard is. */
export function paste(page, text) {
  return page.evaluate((text) => {
    const clipboardData = new DataTransfer();
    clipboardData.setData("text", text);
    document.activeElement.dispatchEvent(new ClipboardEvent("paste", { clipboardData, cancelable: true, bubbles: true }));
  }, text);
}

/** Holds that axe-core finds nothing wrong with the page as it is. */
export async function accessible(page) {
  const session = await page.context().newCDPSession(page);
  // Not by the page, whose policy forbids it.
  await session.send("Runtime.evaluate", { expression: axe });
  const violations = await page.evaluate(async () => {
    const tags = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];
    const found = await window.axe.run(document, { runOnly: tags, preload: false });
    return found.violations.map(({ id, help, nodes }) => {
      const where = nodes.map(({ target, failureSummary }) => `${target.join(" ")}: ${failureSummary}`);
      return `${id}: ${help}\n${where.join("\n")}`;
    });
  });
  await session.detach();
  assert.deepEqual(violations, [], violations.join("\n\n"));
}
