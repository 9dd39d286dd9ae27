// What every end-to-end test stands on: the built site on loopback, a headless browser, and a
// page whose errors fail the test. `cargo xtask test e2e` sets the environment.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { serve } from "./server.mjs";

const pictures = fileURLToPath(new URL("../../target/e2e/", import.meta.url));
let shared;
let browser;

export function setting(name) {
  const value = process.env[name];
  assert.ok(value, `${name} is not set: run this by \`cargo xtask test e2e\``);
  return value;
}

before(async () => {
  mkdirSync(pictures, { recursive: true });
  shared = await serve(setting("MOTIONBENCH_SITE"));
  const args = setting("MOTIONBENCH_BROWSER_ARGUMENTS").split(" ");
  browser = await chromium.launch({
    executablePath: setting("MOTIONBENCH_BROWSER"),
    args,
    chromiumSandbox: !args.includes("--no-sandbox"),
  });
});

after(async () => {
  await browser?.close();
  await shared?.stop();
});

/**
 * One test of the built site. `body` gets a fresh page at the site's address, its `context`,
 * `shot(name)`, which writes a picture to target/e2e, and `forgive(pattern)` for an error that it
 * means to cause. With `own`, the site has a service worker, and a server that the test may stop.
 * The test fails too if the page logs any other error, breaks its Content-Security-Policy, misses
 * a file or asks another server for anything.
 */
export function siteTest(name, body, { own = false, timeout = 120_000 } = {}) {
  test(name, { timeout }, async () => {
    const server = own ? await serve(setting("MOTIONBENCH_SITE")) : shared;
    const serviceWorkers = own ? "allow" : "block";
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, serviceWorkers });
    const wrong = [];
    context.on("page", (page) => watchPage(page, wrong));
    watchContext(context, server.address, wrong);
    const page = await context.newPage();
    const forgiven = [];
    const forgive = (pattern) => forgiven.push(pattern);
    const shot = (picture) => page.screenshot({ path: `${pictures}${picture}.png` });
    try {
      await page.goto(server.address);
      await body(page, { address: server.address, context, server, shot, forgive });
    } catch (error) {
      await shot(`failed ${name}`.replaceAll(/\W+/g, "-")).catch(() => {});
      if (wrong.length > 0) {
        error.message += `\nThe page also reported:\n${wrong.join("\n")}`;
      }
      throw error;
    } finally {
      await context.close();
      if (own) {
        await server.stop();
      }
    }
    const unforgiven = wrong.filter((error) => !forgiven.some((pattern) => pattern.test(error)));
    assert.deepEqual(unforgiven, [], "the page reported errors");
  });
}

/** Adds to `wrong` what goes wrong on a page. */
function watchPage(page, wrong) {
  page.on("pageerror", (error) => wrong.push(`uncaught: ${error.message}`));
  page.on("crash", () => wrong.push("the page crashed"));
  page.on("console", (message) => {
    if (message.type() === "error") {
      wrong.push(`console: ${message.text()}`);
    }
  });
}

/** Adds to `wrong` what goes wrong with what the pages ask for. */
function watchContext(context, address, wrong) {
  context.on("request", (request) => {
    if (!request.url().startsWith(address) && !/^(data|blob):/.test(request.url())) {
      wrong.push(`asked another server: ${request.url()}`);
    }
  });
  context.on("requestfailed", (request) => {
    const { errorText } = request.failure() ?? {};
    // A page that goes away asks no more.
    if (errorText !== "net::ERR_ABORTED") {
      wrong.push(`failed: ${request.url()} ${errorText}`);
    }
  });
  context.on("response", (response) => {
    if (response.status() >= 400) {
      wrong.push(`${response.status()}: ${response.url()}`);
    }
  });
}
