// Other builds of the site, made from the one that was built.

import { createHash } from "node:crypto";
import { cpSync, mkdtempSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { setting } from "./harness.mjs";

const root = fileURLToPath(new URL("../../", import.meta.url));

/** A site that can be changed: `text(name)` reads a file, `write(name, text)` writes one. */
function copy() {
  const folder = mkdtempSync(join(root, "target/e2e/site-"));
  cpSync(setting("MOTIONBENCH_SITE"), folder, { recursive: true });
  const text = (name) => readFileSync(join(folder, name), "utf8");
  const write = (name, contents) => writeFileSync(join(folder, name), contents);
  const [, version] = /VERSION = "(\w+)"/.exec(text("sw.js"));
  const remove = () => rmSync(folder, { recursive: true });
  return { folder, text, write, version, remove };
}

function digest(contents) {
  return `sha256-${createHash("sha256").update(contents).digest("base64")}`;
}

/** The site as a later build would be: another version, whose files have other contents and names. */
export function newerSite() {
  const site = copy();
  const version = [...site.version].reverse().join("");
  renameSync(join(site.folder, site.version), join(site.folder, version));
  const before = site.text("index.html");
  const after = before.replace(site.version, version).replace("<title>", "<title>Newer ");
  site.write("index.html", after);
  const worker = site.text("sw.js").replaceAll(site.version, version);
  site.write("sw.js", worker.replace(digest(before), digest(after)));
  return { ...site, version };
}

/** The site as it is built for development. */
export function siteUnderDevelopment() {
  const site = copy();
  for (const file of ["worker.js", "worker_bg.wasm", "worker_loader.js"]) {
    renameSync(join(site.folder, site.version, file), join(site.folder, file));
  }
  site.write("index.html", site.text("index.html").replace(site.version, "development"));
  site.write("sw.js", readFileSync(join(root, "app/service-worker/remove.js")));
  return site;
}
