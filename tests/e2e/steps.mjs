// What a person does at the page and sees there, for tests that say it in their own words.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Waits until `check` gives true. Playwright's own waitForFunction evaluates text, which the page's policy forbids. */
export async function eventually(what, check) {
  const end = Date.now() + 20_000;
  let seen = await check();
  while (seen !== true) {
    assert.ok(Date.now() < end, `${what}; there was ${JSON.stringify(seen)}`);
    await new Promise((resolve) => setTimeout(resolve, 50));
    seen = await check();
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
