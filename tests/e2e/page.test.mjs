// The built page starts, under its policy.

import assert from "node:assert/strict";
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
