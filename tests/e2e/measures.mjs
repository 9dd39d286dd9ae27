// What the page takes of the main thread. The machine may be busy with other things: the best of some moments counts.

import assert from "node:assert/strict";

const MOMENTS = 5;

/** Holds that the page paints `least` frames a second. */
export async function paints(page, least) {
  let best = { rate: 0 };
  for (let moment = 0; moment < MOMENTS && best.rate < least; moment += 1) {
    const measured = await frames(page, 1.5);
    best = measured.rate > best.rate ? measured : best;
  }
  console.log(`${best.rate.toFixed(1)} frames a second, the longest pause ${best.longest.toFixed(0)} ms`);
  assert.ok(best.rate >= least, `${best.rate} frames a second`);
}

/** Frames a second that the page paints for `seconds`, and the longest pause between two, in ms. */
function frames(page, seconds) {
  return page.evaluate(
    (seconds) =>
      new Promise((resolve) => {
        const start = performance.now();
        let [count, last, longest] = [0, start, 0];
        const frame = (now) => {
          count += 1;
          longest = Math.max(longest, now - last);
          last = now;
          if (now - start < seconds * 1000) {
            requestAnimationFrame(frame);
          } else {
            resolve({ rate: (count * 1000) / (now - start), longest });
          }
        };
        requestAnimationFrame(frame);
      }),
    seconds,
  );
}

/**
 * What the main thread does a frame, in ms of its own time: `drawing` before a frame is painted, `all` in all; measured
 * again until it `isLittle`. The whole includes what the browser itself does, without a graphics card.
 */
export async function busy(page, isLittle) {
  const client = await page.context().newCDPSession(page);
  await client.send("Performance.enable", { timeDomain: "threadTicks" });
  const task = async () => {
    const { metrics } = await client.send("Performance.getMetrics");
    return metrics.find((metric) => metric.name === "TaskDuration").value * 1000;
  };
  let best = { drawing: Infinity, all: Infinity, frames: 0 };
  for (let moment = 0; moment < MOMENTS && !(moment > 0 && isLittle(best)); moment += 1) {
    const before = await task();
    const seen = await drawing(page, 2);
    const all = ((await task()) - before) / seen.frames;
    console.log(
      `drawing ${seen.mean.toFixed(2)} ms, 95 % within ${seen.most.toFixed(2)} ms, ` +
        `the main thread ${all.toFixed(2)} ms a frame (${seen.frames} frames)`,
    );
    best = {
      drawing: Math.min(best.drawing, seen.mean),
      all: Math.min(best.all, all),
      frames: Math.max(best.frames, seen.frames),
    };
  }
  await client.detach();
  return best;
}

/** What the page does before its frames while `seconds` pass, ms: the mean, and what 95 % stay within. */
function drawing(page, seconds) {
  return page.evaluate(async (seconds) => {
    // By the time of the frame: several may draw before the same one.
    const spent = new Map();
    const original = window.requestAnimationFrame;
    window.requestAnimationFrame = (call) =>
      original.call(window, (now) => {
        const start = performance.now();
        call(now);
        spent.set(now, (spent.get(now) ?? 0) + performance.now() - start);
      });
    await new Promise((resolve) => setTimeout(resolve, seconds * 1000));
    window.requestAnimationFrame = original;
    const times = [...spent.values()].sort((a, b) => a - b);
    const mean = times.reduce((sum, ms) => sum + ms, 0) / times.length;
    return { mean, most: times[Math.floor(times.length * 0.95)], frames: times.length };
  }, seconds);
}
