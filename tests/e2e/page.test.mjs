// The built page starts, with its worker, and within its size.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import { siteTest } from "./harness.mjs";

siteTest("the page starts", async (page, { shot }) => {
  assert.equal(await page.title(), "Motionbench");
  await page.getByRole("main").waitFor();
  await shot("page");
});

siteTest("an inline script is refused by the page's policy", async (page, { forgive }) => {
  forgive(/violates the following Content Security Policy/);
  const ran = await page.evaluate(() => {
    const script = document.createElement("script");
    script.textContent = "window.ran = true";
    document.head.append(script);
    return window.ran === true;
  });
  assert.equal(ran, false);
});

test("everything the site loads is at most 1.2 MB compressed", () => {
  const folder = process.env.MOTIONBENCH_SITE;
  const sizes = readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => [entry.name, gzipSync(readFileSync(join(entry.parentPath ?? entry.path, entry.name))).length]);
  const total = sizes.reduce((sum, [, size]) => sum + size, 0);
  for (const [name, size] of sizes) {
    console.log(`${String(size).padStart(9)} ${name}`);
  }
  assert.ok(total <= 1_200_000, `${total} bytes`);
});
