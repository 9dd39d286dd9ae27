// The terminal's tools: line settings, paste, files, capture, copy, clear, break.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { siteTest } from "./harness.mjs";
import { accessible, eventually, paste, printed, printedEnd } from "./steps.mjs";

/** Sets the terminal's end of the line. */
async function setLine(page, settings) {
  await page.getByRole("button", { name: "Line settings" }).click();
  const dialog = page.getByRole("dialog", { name: "Line settings" });
  for (const [label, value] of Object.entries(settings)) {
    await dialog.getByLabel(label).selectOption({ label: value });
  }
  await dialog.getByRole("button", { name: "Set", exact: true }).click();
  await dialog.waitFor({ state: "hidden" });
}

/** Chooses one of the tools that are not needed all the time. */
async function more(page, name) {
  await page.getByRole("group", { name: "Terminal" }).getByRole("button", { name: "More" }).click();
  await page.getByRole("button", { name, exact: true }).click();
}

siteTest("a wrong baud rate gives garbage, the right one words again", async (page, { shot }) => {
  await printedEnd(page, ">");
  await setLine(page, { Baud: "1200", Parity: "even", "Data bits": "7" });
  await page.locator(".status").getByText("1200 7E1").waitFor();
  await page.keyboard.type("?1\n");
  await eventually("something else than the answer is printed", async () => {
    const text = await printed(page);
    return (text.length > 1 && !text.includes("?1")) || text;
  });
  await shot("wrong-baud-rate");
  await page.getByRole("button", { name: "Line settings" }).click();
  const dialog = page.getByRole("dialog");
  await dialog.getByText("9600 8N1").waitFor();
  await dialog.getByRole("button", { name: "As the controller" }).click();
  await dialog.getByRole("button", { name: "Set", exact: true }).click();
  // The keyboard is in the terminal again.
  await page.keyboard.press("Control+c");
  await page.keyboard.type("\n?6*7\n");
  await printedEnd(page, "?6*7\n 42\n>");
});

siteTest("a paste tells how far it is and can be cancelled; what is typed comes behind it", async (page, { shot }) => {
  await printedEnd(page, ">");
  const lines = Array.from({ length: 40 }, (_, i) => `${10 * (i + 1)} REM ${"X".repeat(50)}`);
  await paste(page, `${lines.join("\n")}\n`);
  await page.getByRole("progressbar", { name: "Sent" }).waitFor();
  await page.keyboard.type("?7\n");
  await shot("paste");
  await printedEnd(page, ">?7\n 7\n>");
  await page.getByRole("progressbar", { name: "Sent" }).waitFor({ state: "detached" });
  await paste(page, "REM PASTED\n".repeat(100_000));
  await page.getByText("of 1 100 000 characters".replaceAll(" ", "\u202f").replace("of\u202f", "of ").replace("\u202fch", " ch"))
    .waitFor();
  await page.getByRole("button", { name: "Cancel" }).click();
  await page.getByRole("progressbar", { name: "Sent" }).waitFor({ state: "detached" });
  await page.keyboard.type("\n?8\n");
  await printedEnd(page, "?8\n 8\n>");
});

siteTest("a file is sent line by line as the controller asks for it", async (page, { shot }) => {
  await printedEnd(page, ">");
  const lines = Array.from({ length: 20 }, (_, i) => `${10 * (i + 1)} PRINT ${i}`);
  await page.getByRole("button", { name: "Send file" }).click();
  const dialog = page.getByRole("dialog", { name: "Send a text file" });
  await dialog.getByRole("button", { name: "Send", exact: true }).click();
  await dialog.getByText("Choose a file first").waitFor();
  const buffer = Buffer.from(`${lines.join("\r\n")}\r\nRUN\r\n`);
  await dialog.getByLabel("File").setInputFiles({ name: "COUNT.BAS", mimeType: "text/plain", buffer });
  await dialog.getByLabel("Pause behind a line").fill("50");
  await dialog.getByRole("button", { name: "Send", exact: true }).click();
  await page.getByText("Sending COUNT.BAS").waitFor();
  await shot("send-file");
  await printedEnd(page, " 18\n 19\n>");
});

siteTest("what arrives is captured to a file", async (page) => {
  await printedEnd(page, ">");
  await page.getByRole("button", { name: "Capture" }).click();
  await page.keyboard.type("?\"KEPT\"\n");
  await printedEnd(page, "KEPT\n>");
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "Save capture" }).click();
  const file = await (await download).path();
  assert.equal(readFileSync(file, "utf8"), "?\"KEPT\"\r\nKEPT\r\n>");
  await page.getByRole("button", { name: "Capture", exact: true }).waitFor();
});

siteTest("a break goes over the line; all is copied, and cleared", async (page, { context, address }) => {
  await context.grantPermissions(["clipboard-read", "clipboard-write"], { origin: new URL(address).origin });
  await printedEnd(page, ">");
  await page.keyboard.type("10 GOTO 10\nRUN\n");
  await page.getByText("running", { exact: true }).waitFor();
  // This controller reads it as a character with a framing error, and goes on.
  await more(page, "Send a break");
  await page.keyboard.press("Control+c");
  await printedEnd(page, "BREAK IN 10\n>");
  await more(page, "Copy all");
  await page.getByText("All of it is on the clipboard.").waitFor();
  assert.equal(await page.evaluate(() => navigator.clipboard.readText()), ">10 GOTO 10\n>RUN\nBREAK IN 10\n>\n");
  await more(page, "Clear");
  await printedEnd(page, ">");
  await eventually("only the prompt is left", async () => {
    const text = await printed(page);
    return text === ">" || text;
  });
  await page.keyboard.type("?2\n");
  await printedEnd(page, ">?2\n 2\n>");
});

siteTest("files go to the controller's disks and come from there", async (page, { shot }) => {
  await printedEnd(page, ">");
  await page.getByRole("button", { name: "Disks" }).click();
  const dialog = page.getByRole("dialog", { name: "Disks of the controller" });
  const file = (name, text) => ({ name, mimeType: "text/plain", buffer: Buffer.from(text) });
  await dialog.getByLabel("Files for B:").setInputFiles([file("feed.bas", "10 PRINT 6*7\r\n")]);
  await dialog.getByText("B:FEED.BAS is on the disk.").waitFor();
  await dialog.getByRole("region", { name: "Disk B:" }).getByText("FEED.BAS", { exact: true }).waitFor();
  await dialog.getByLabel("Files for A:").setInputFiles([file("much too long a name.bas", "10 END")]);
  await dialog.getByText(/is no file name of this device/).waitFor();
  await accessible(page);
  await shot("disks");
  const download = page.waitForEvent("download");
  await dialog.getByRole("button", { name: "Save B:FEED.BAS as a file" }).click();
  const saved = await download;
  assert.equal(saved.suggestedFilename(), "FEED.BAS");
  assert.equal(readFileSync(await saved.path(), "latin1"), "10 PRINT 6*7\r\n");
  // Dropped on the disk.
  const data = await page.evaluateHandle(() => {
    const transfer = new DataTransfer();
    transfer.items.add(new File(["10 PRINT 7*7"], "drop.bas"));
    return transfer;
  });
  await page.dispatchEvent(".disk[aria-label='Disk A:']", "drop", { dataTransfer: data });
  await dialog.getByText("A:DROP.BAS is on the disk.").waitFor();
  await page.keyboard.press("Escape");
  await page.getByRole("textbox", { name: "Terminal" }).focus();
  await page.keyboard.type('RUN "B:FEED"\nRUN "DROP"\n');
  await printedEnd(page, ' 42\n>RUN "DROP"\n 49\n>');
});
