// Bundles the page's editor into target/editor/editor.js. Trunk runs it before every build.

import { mkdir, readFile, readdir, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = fileURLToPath(new URL("../../", import.meta.url));
const bundle = join(root, "target/editor/editor.js");

const { build } = await import("esbuild").catch((error) => {
  console.error("The packages of package-lock.json are not installed: `cargo xtask serve` does it, or `npm ci`.");
  throw error;
});

const built = await build({
  absWorkingDir: root,
  entryPoints: ["app/editor/element.js"],
  bundle: true,
  format: "esm",
  target: "es2022",
  minify: true,
  metafile: true,
  write: false,
  logLevel: "warning",
});
const text = `${await licences(built.metafile)}${built.outputFiles[0].text}`;
// A file that is left alone keeps its date, and whatever looks at dates has nothing to do.
if ((await readFile(bundle, "utf8").catch(() => null)) !== text) {
  await mkdir(dirname(bundle), { recursive: true });
  await writeFile(bundle, text);
}

/** The licences of the bundled packages, which ask to go with every copy: each text once, as a comment. */
async function licences(metafile) {
  const folder = /^.*node_modules\/(?:@[^/]+\/)?[^/]+/;
  const packages = new Set(Object.keys(metafile.inputs).flatMap((input) => input.match(folder) ?? []));
  const holders = new Map();
  for (const name of packages) {
    const file = (await readdir(join(root, name))).find((file) => /^licen[cs]e/i.test(file));
    if (!file) {
      throw new Error(`${name} has no licence beside it`);
    }
    const licence = (await readFile(join(root, name, file), "utf8")).trim();
    holders.set(licence, [...(holders.get(licence) ?? []), name.replace(/.*node_modules\//, "")]);
  }
  const texts = [...holders].map(([licence, names]) => `${names.sort().join(", ")}\n\n${licence}`);
  return `/*! Contains:\n\n${texts.sort().join("\n\n\n").replaceAll("*/", "* /")}\n*/\n`;
}
