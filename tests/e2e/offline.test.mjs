// The site without a network, and the way from one version of it to the next.

import assert from "node:assert/strict";
import { siteTest } from "./harness.mjs";
import { newerSite, siteUnderDevelopment } from "./sites.mjs";

/** A cold start without a network may take this long until a line can be typed. */
const START_MS = 1500;

/** Waits until the terminal's text ends with `end`. */
async function printedEnd(page, end) {
  await page.waitForFunction((end) => {
    const rows = [...document.querySelectorAll(".row")].map((row) => row.textContent.trimEnd());
    return rows.join("\n").trimEnd().endsWith(end);
  }, end);
}

/** Waits until the page says that its files are kept. */
function worksOffline(page) {
  return page.getByText("works offline", { exact: true }).waitFor();
}

function version(page) {
  return page.locator("html").getAttribute("data-version");
}

/** Lets the browser look for a newer version, as it does by itself now and then. */
function lookForNewer(page) {
  return page.evaluate(async () => {
    const registration = await navigator.serviceWorker.getRegistration();
    await registration.update();
  });
}

/** The versions of which files are kept. */
function keptVersions(page) {
  return page.evaluate(async () => (await caches.keys()).map((name) => name.split(" ").at(-1)));
}

/** Waits until the files of one version are kept, and of no other. */
async function keepsOnly(page, version) {
  await page.waitForFunction(
    async (version) => {
      const names = await caches.keys();
      return names.length === 1 && names[0].endsWith(` ${version}`);
    },
    version,
  );
}

const own = { own: true };

siteTest(
  "a page that was visited once starts without the network",
  async (page, { address, context, server, shot }) => {
    await worksOffline(page);
    await server.stop();
    const cold = await context.newPage();
    const start = performance.now();
    await cold.goto(address);
    await printedEnd(cold, ">");
    const took = performance.now() - start;
    console.log(`ready to type in ${took.toFixed(0)} ms`);
    assert.ok(took <= START_MS, `${took} ms`);
    await cold.keyboard.type("?6*7\n");
    await printedEnd(cold, ">?6*7\n 42\n>");
    await worksOffline(cold);
    // By its file's name, too, and again.
    await page.goto(`${address}index.html`);
    await page.reload();
    await printedEnd(page, ">");
    await shot("offline");
  },
  own,
);

siteTest(
  "a newer version waits until the user accepts it",
  async (page, { context, server, shot }) => {
    await worksOffline(page);
    const [older, site] = [await version(page), newerSite()];
    server.change(site.folder);
    await printedEnd(page, ">");
    await page.keyboard.type("10 PRINT \"STILL HERE\"\n");
    await lookForNewer(page);
    const prompt = page.getByText("A newer version of Motionbench is ready");
    await prompt.waitFor();
    await shot("newer-version");
    // The old version goes on, also in a page that is opened now.
    await page.keyboard.type("RUN\n");
    await printedEnd(page, "\nSTILL HERE\n>");
    const second = await context.newPage();
    await second.goto(server.address);
    await second.getByText("works offline, newer version ready").waitFor();
    assert.equal(await version(second), older);
    assert.deepEqual((await keptVersions(page)).sort(), [older, site.version].sort());
    await second.close();
    await page.getByRole("button", { name: "Later" }).click();
    await prompt.waitFor({ state: "detached" });
    await page.reload();
    assert.equal(await version(page), older);
    await page.getByRole("button", { name: "Reload now" }).click();
    await page.waitForFunction(() => document.title === "Newer Motionbench");
    await printedEnd(page, ">");
    assert.equal(await version(page), site.version);
    await keepsOnly(page, site.version);
    await server.stop();
    await page.reload();
    await printedEnd(page, ">");
    assert.equal(await version(page), site.version);
    site.remove();
  },
  own,
);

siteTest(
  "a page goes on in its version when another one changes over",
  async (page, { address, context, server }) => {
    await worksOffline(page);
    const [older, site] = [await version(page), newerSite()];
    const second = await context.newPage();
    await second.goto(address);
    server.change(site.folder);
    await lookForNewer(second);
    await second.getByRole("button", { name: "Reload now" }).click();
    await second.waitForFunction(() => document.title === "Newer Motionbench");
    await printedEnd(second, ">");
    // Its simulator can be started anew, although the server has only the newer one.
    assert.equal(await version(page), older);
    const heard = await page.evaluate(
      (older) =>
        new Promise((resolve, reject) => {
          const worker = new Worker(`./${older}/worker_loader.js`, { type: "module", name: "mc600" });
          worker.onmessage = (event) => resolve(event.data[0]);
          worker.onerror = () => reject(new Error("no worker"));
        }),
      older,
    );
    assert.match(heard, /Ready/);
    assert.deepEqual((await keptVersions(page)).sort(), [older, site.version].sort());
    await page.getByRole("button", { name: "Reload now" }).click();
    await page.waitForFunction(() => document.title === "Newer Motionbench");
    await keepsOnly(page, site.version);
    site.remove();
  },
  own,
);

siteTest(
  "a version that is not whole is not used",
  async (page, { forgive, server }) => {
    await worksOffline(page);
    const [older, site] = [await version(page), newerSite()];
    // The server has some files of yet another version.
    site.write("boot.js", `${site.text("boot.js")}\n// changed`);
    server.change(site.folder);
    forgive(/integrity/);
    forgive(/boot\.js/);
    await lookForNewer(page).catch(() => {});
    await page.waitForFunction(async () => !(await navigator.serviceWorker.getRegistration()).installing);
    await keepsOnly(page, older);
    await page.reload();
    await worksOffline(page);
    assert.equal(await version(page), older);
    assert.equal(await page.getByText("A newer version").count(), 0);
    site.remove();
  },
  own,
);

siteTest(
  "a site under development is not kept, and takes away what a published one left",
  async (page, { server }) => {
    await worksOffline(page);
    const site = siteUnderDevelopment();
    server.change(site.folder);
    await page.reload();
    await page.waitForFunction(() => document.documentElement.dataset.version === "development");
    await printedEnd(page, ">");
    await page.waitForFunction(async () => (await navigator.serviceWorker.getRegistrations()).length === 0);
    assert.deepEqual(await page.evaluate(() => caches.keys()), []);
    await page.getByText("needs the network").waitFor();
    site.remove();
  },
  own,
);

siteTest(
  "the site can be installed",
  async (page, { address, context }) => {
    await worksOffline(page);
    const session = await context.newCDPSession(page);
    const { errors } = await session.send("Page.getAppManifest");
    assert.deepEqual(errors, []);
    const { installabilityErrors } = await session.send("Page.getInstallabilityErrors");
    // A browser context of a test is incognito.
    const other = installabilityErrors.filter(({ errorId }) => errorId !== "in-incognito");
    assert.deepEqual(other, []);
    const manifest = await (await page.request.get(`${address}manifest.webmanifest`)).json();
    for (const icon of manifest.icons) {
      const size = await page.evaluate(async ({ src }) => {
        const image = new Image();
        image.src = src;
        await image.decode();
        return `${image.naturalWidth}x${image.naturalHeight}`;
      }, icon);
      assert.ok(icon.sizes === "any" || icon.sizes === size, `${icon.src} is ${size}`);
    }
    const purposes = manifest.icons.map(({ sizes, purpose }) => `${purpose} ${sizes}`);
    assert.deepEqual(purposes, ["any any", "any 192x192", "any 512x512", "maskable 192x192", "maskable 512x512"]);
  },
  own,
);
