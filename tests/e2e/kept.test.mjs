// Work that is kept: over a reload, a crash, a second tab, an import and a page that cannot read it.

import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import { siteTest } from "./harness.mjs";
import { eventually, printedEnd, programText, writeProgram } from "./steps.mjs";

const folder = fileURLToPath(new URL("../../target/e2e/", import.meta.url));

/** Waits until the page has its project. */
async function opened(page) {
  await printedEnd(page, ">");
  await page.locator(".status .saved").getByText(/saved|read-only/).waitFor();
}

/** Writes another program over the one in the editor. */
async function write(page, text) {
  await opened(page);
  await writeProgram(page, text);
}

/** Waits until the program in the editor is `text`. */
async function shows(page, text) {
  await opened(page);
  await eventually("the program is there", async () => {
    const seen = await programText(page);
    return seen === text || seen;
  });
}

/** Waits until all changes are kept. */
async function kept(page) {
  // A change is seen by the page in its next frame.
  await page.waitForTimeout(100);
  await page.locator(".status .saved").getByText(/^saved \d\d:\d\d$/).waitFor();
}

async function type(page, text) {
  await page.getByRole("textbox", { name: "Terminal" }).focus();
  await page.keyboard.type(text);
}

function project(page) {
  return page.getByRole("dialog", { name: "Project" });
}

/** Opens the project's dialog. */
async function openProject(page) {
  await page.getByTitle(/^The project:/).click();
  await project(page).waitFor();
}

siteTest("program, files and settings come back after a reload", async (page, { shot }) => {
  await write(page, "10 REM MINE\n20 END");
  await page.getByRole("combobox", { name: "Simulation speed" }).selectOption("max");
  await type(page, "10 PRINT \"FROM B\"\nSAVE \"B:MINE\"\nSAVE \"A:MINE\"\n20 REM RAM\n");
  await printedEnd(page, ">20 REM RAM\n>");
  // The controller is asked twice a second, and what it holds is kept half a second later.
  await page.waitForTimeout(1200);
  await kept(page);
  await page.reload();
  await shows(page, "10 REM MINE\n20 END");
  assert.equal(await page.getByRole("combobox", { name: "Simulation speed" }).inputValue(), "max");
  await type(page, "LIST\n");
  await printedEnd(page, "10 PRINT \"FROM B\"\n20 REM RAM\n>");
  await type(page, "FILES \"A:*.*\"\n");
  await printedEnd(page, "BYTES FREE\n>");
  assert.equal(await page.locator(".row", { hasText: /^MINE\.BAS/ }).count(), 1);
  // The mains switch is true to the device: RAM is lost, FLASH is not.
  const power = page.getByRole("switch", { name: "Power" });
  await power.click();
  await power.click();
  await page.getByText("idle", { exact: true }).waitFor();
  await type(page, "RUN \"B:MINE\"\n");
  await printedEnd(page, "\nFROM B\n>");
  await shot("kept");
});

siteTest("a page that is closed at once has kept the last letter", async (page, { address, context }) => {
  let last = page;
  for (let round = 1; round <= 4; round += 1) {
    const text = `10 REM ROUND ${round}`;
    await write(last, text);
    await last.close({ runBeforeUnload: round % 2 === 0 });
    last = await context.newPage();
    await last.goto(address);
    await shows(last, text);
  }
});

siteTest("a page that is left while one types has kept the last letter", async (page) => {
  for (let round = 1; round <= 3; round += 1) {
    await write(page, "10 REM ROUND ");
    await page.keyboard.insertText(`${round}`);
    await page.reload();
    await shows(page, `10 REM ROUND ${round}`);
  }
});

siteTest("a page that is too busy to say goodbye has kept the last change", async (page, { address, context }) => {
  await opened(page);
  // The page has had some time: what it wrote when it was opened is long done.
  await page.waitForTimeout(1000);
  await write(page, "10 REM BUSY");
  // A browser that closes a page waits half a second for it.
  await page.evaluate(() =>
    setTimeout(() => {
      const end = performance.now() + 2000;
      while (performance.now() < end);
    }),
  );
  await page.close();
  const next = await context.newPage();
  await next.goto(address);
  await shows(next, "10 REM BUSY");
});

siteTest("a page that crashes loses nothing that is older than a second", async (page, { address, context, forgive }) => {
  forgive(/crashed/);
  await write(page, "10 REM BEFORE THE CRASH");
  await page.waitForTimeout(1000);
  await page.goto("chrome://crash").catch(() => {});
  const next = await context.newPage();
  await next.goto(address);
  await shows(next, "10 REM BEFORE THE CRASH");
});

siteTest("a second tab is read-only until the first is closed", async (page, { address, context }) => {
  await write(page, "10 REM FIRST TAB");
  await kept(page);
  const second = await context.newPage();
  await second.goto(address);
  await second.getByText("This project is open in another tab").waitFor();
  await shows(second, "10 REM FIRST TAB");
  await second.screenshot({ path: `${folder}second-tab.png` });
  await page.close();
  await kept(second);
  await write(second, "10 REM SECOND TAB");
  await kept(second);
  // What one tab has missed is not overwritten by it.
  const third = await context.newPage();
  await third.goto(address);
  await third.getByText("This project is open in another tab").waitFor();
  await write(second, "10 REM LAST WORDS");
  await kept(second);
  await second.close();
  await third.getByText("The other tab has closed the project").waitFor();
  await third.getByRole("button", { name: "Reload" }).click();
  await shows(third, "10 REM LAST WORDS");
});

siteTest("a project goes out to a file and comes back, and nothing is overwritten for good", async (page, { shot }) => {
  await write(page, "10 REM TO THE FILE\n20 END");
  await kept(page);
  await openProject(page);
  await project(page).getByLabel("Name").fill("Feeder 2");
  await project(page).getByLabel("Name").press("Tab");
  const download = page.waitForEvent("download");
  await project(page).getByRole("button", { name: "Export to a file" }).click();
  const file = await download;
  assert.equal(file.suggestedFilename(), "Feeder-2.motionbench.json");
  const path = `${folder}${file.suggestedFilename()}`;
  await file.saveAs(path);
  const text = await readFile(path, "utf8");
  assert.match(text, /"10 REM TO THE FILE\\n",\n/);
  await project(page).getByRole("button", { name: "Close" }).click();
  await write(page, "10 REM AFTER IT");

  const choose = async (path) => {
    await openProject(page);
    const chooser = page.waitForEvent("filechooser");
    await project(page).getByRole("button", { name: "Import a file" }).click();
    await (await chooser).setFiles(path);
  };
  await choose(fileURLToPath(import.meta.url));
  await project(page).getByText("This project cannot be read: expected value at line 1 column 1.").waitFor();
  await shot("project-wrong-file");
  await project(page).getByRole("button", { name: "Close" }).click();
  await writeFile(`${path}.newer`, text.replace('"version": 1', '"version": 99'));
  await choose(`${path}.newer`);
  await project(page).getByText("was written by a newer Motionbench").waitFor();
  await project(page).getByRole("button", { name: "Close" }).click();
  await shows(page, "10 REM AFTER IT");

  await choose(path);
  await shows(page, "10 REM TO THE FILE\n20 END");
  await openProject(page);
  await shot("project");
  const before = project(page).getByRole("button", { name: /Go back to .* before an import/ });
  await before.click();
  await shows(page, "10 REM AFTER IT");
});

siteTest("a project that the page cannot read stays as it is until the user starts over", async (page, { shot }) => {
  await write(page, "10 REM OLD");
  await kept(page);
  // From a later version of the page.
  const stored = (change) =>
    page.evaluate(
      (change) =>
        new Promise((resolve) => {
          const opening = indexedDB.open("motionbench");
          opening.onsuccess = () => {
            const database = opening.result;
            const store = database.transaction("present", "readwrite").objectStore("present");
            const reading = store.get("project");
            reading.onsuccess = () => {
              const text = change ? reading.result.replace('"version":1', '"version":99') : reading.result;
              store.put(text, "project").onsuccess = () => {
                database.close();
                resolve(text);
              };
            };
          };
        }),
      change,
    );
  const newer = await stored(true);
  await page.reload();
  await page.getByText("was written by a newer Motionbench").waitFor();
  await shot("project-newer");
  const field = page.getByRole("textbox", { name: "Program" });
  await field.click();
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText("10 REM NEW");
  await page.waitForTimeout(1000);
  assert.equal(await stored(false), newer);
  await page.getByRole("button", { name: "Start over" }).click();
  await kept(page);
  await page.reload();
  await shows(page, "10 REM NEW");
  await openProject(page);
  const download = page.waitForEvent("download");
  await project(page).getByRole("button", { name: /Export .* could not be read/ }).click();
  const path = await (await download).path();
  assert.equal(await readFile(path, "utf8"), newer);
});

siteTest("a browser that keeps nothing is said, and the page works", async (page, { shot }) => {
  await page.addInitScript(() => Object.defineProperty(window, "indexedDB", { value: undefined }));
  await page.reload();
  await page.getByText("This browser does not let the page keep your work").waitFor();
  await shot("not-kept");
  await printedEnd(page, ">");
  await type(page, "?6*7\n");
  await printedEnd(page, "\n 42\n>");
  const download = page.waitForEvent("download");
  await page.locator(".notice").getByRole("button", { name: "Export" }).click();
  assert.match((await download).suggestedFilename(), /\.motionbench\.json$/);
});
