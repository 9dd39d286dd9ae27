// Whatever kills the page or its simulator, no edit that is older than a second is lost.

import assert from "node:assert/strict";
import { siteTest } from "./harness.mjs";
import { programText, writeProgram } from "./steps.mjs";

/** `MOTIONBENCH_KILLS=100` for the long run. */
const KILLS = Number(process.env.MOTIONBENCH_KILLS ?? 15);
const SECOND_MS = 1000;

/** Random numbers below `end`, the same in every run. */
function random(seed) {
  return (end) => {
    seed = (Math.imul(seed, 1_103_515_245) + 12_345) >>> 0;
    return Math.floor((seed / 2 ** 32) * end);
  };
}

/** Waits until the page has its project; returns the program in the editor. */
async function program(page) {
  await page.locator(".status .saved").getByText(/^sav/).waitFor();
  // The editor shows it in the next frame.
  await page.waitForTimeout(100);
  return programText(page);
}

const fresh = async (page, { address, context }) => {
  const next = await context.newPage();
  await next.goto(address);
  return next;
};

/** Ways to go; each gives the page that goes on. */
const ends = [
  async (page) => {
    await page.reload();
    return page;
  },
  async (page, site) => {
    await page.close();
    return fresh(page, site);
  },
  async (page, site) => {
    await page.goto("chrome://crash").catch(() => {});
    const next = await fresh(page, site);
    await page.close();
    return next;
  },
  async (page) => {
    // The simulator alone; the page goes on, and is loaded again a moment later.
    await page.workers()[0]?.evaluate(() => self.close()).catch(() => {});
    await page.reload();
    return page;
  },
];

siteTest(
  `${KILLS} random kills lose no edit that is older than a second`,
  async (page, { address, context, forgive }) => {
    forgive(/crashed/);
    const below = random(7);
    let edits = [{ text: await program(page), at: 0 }];
    for (let kill = 1; kill <= KILLS; kill += 1) {
      for (let edit = 0; edit <= below(4); edit += 1) {
        const text = `10 REM KILL ${kill} EDIT ${edit}`;
        await writeProgram(page, text);
        edits.push({ text, at: performance.now() });
        await page.waitForTimeout(below(800));
      }
      const killed = performance.now();
      page = await ends[below(ends.length)](page, { address, context });
      const found = await program(page);
      const last = edits.findLastIndex(({ text }) => text === found);
      assert.ok(last >= 0, `the program is ${found}`);
      const lost = edits.slice(last + 1).filter(({ at }) => killed - at > SECOND_MS);
      assert.deepEqual(lost, [], `kill ${kill} brought back ${found}`);
      edits = [edits[last]];
    }
  },
  { timeout: 60_000 + KILLS * 10_000 },
);
