// SPDX-License-Identifier: Apache-2.0
// Bundles the page and the viewer into dist/: the same sources give the same bytes.
//   node build.mjs MODULES           writes dist/
//   node build.mjs MODULES --check   changes nothing; exits 1 and names the files that differ
// MODULES is the node_modules folder that package-lock.json describes. tools/page calls this.
import { readFile, writeFile, mkdir, readdir } from "node:fs/promises";
import { createRequire } from "node:module";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const here = dirname(fileURLToPath(import.meta.url));
const modules = resolve(process.argv[2]);
const { build } = createRequire(join(modules, "esbuild"))("esbuild");
const LIBRARIES = ["three", "uplot"];

const settings = {
  absWorkingDir: here,
  bundle: true,
  minify: true,
  write: false,
  charset: "utf8",
  legalComments: "none", // LICENSES.txt has them
  target: "es2022",
  outdir: "dist",
  nodePaths: [modules],
  logLevel: "warning",
};

/** Style sheets that a script brings along as text: bundled and minified. */
const cssAsText = {
  name: "css-as-text",
  setup({ onLoad }) {
    onLoad({ filter: /\.css$/ }, async ({ path }) => {
      const { outputFiles } = await build({ ...settings, entryPoints: [path] });
      return { contents: outputFiles[0].text, loader: "text" };
    });
  },
};

/** What was bundled: file name to bytes. */
async function bundled() {
  const page = await build({
    ...settings,
    entryPoints: ["src/app.js", "src/app.css"],
    format: "esm",
  });
  const worker = await build({
    ...settings,
    entryPoints: ["src/edit_worker.js"],
    format: "iife",
  });
  const viewer = await build({
    ...settings,
    entryPoints: ["src/viewer.js"],
    format: "iife",
    plugins: [cssAsText],
  });
  return new Map(
    [...page.outputFiles, ...worker.outputFiles, ...viewer.outputFiles].map((file) => [
      file.path.slice(join(here, "dist").length + 1),
      Buffer.from(file.contents),
    ]),
  );
}

async function licences() {
  const parts = [
    "The bundles app.js, app.css, edit_worker.js and viewer.js are built from tools/studio/page/src (Apache-2.0)\n" +
      "and hold parts of these libraries:\n",
  ];
  for (const name of LIBRARIES) {
    const folder = join(modules, name);
    const { version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    const text = await readFile(join(folder, "LICENSE"), "utf8");
    parts.push(`${"=".repeat(80)}\n${name} ${version}\n\n${text.trim()}\n`);
  }
  return Buffer.from(parts.join("\n"));
}

const files = await bundled();
files.set("index.html", await readFile(join(here, "src/index.html")));
files.set("LICENSES.txt", await licences());

const out = join(here, "dist");
if (process.argv.includes("--check")) {
  const there = await readdir(out).catch(() => []);
  const differ = there.filter((name) => !files.has(name));
  for (const [name, bytes] of files) {
    const old = await readFile(join(out, name)).catch(() => null);
    if (!old || !old.equals(bytes)) differ.push(name);
  }
  if (differ.length) {
    console.error(`tools/studio/page/dist differs from its sources: ${differ.sort().join(", ")}`);
    process.exit(1);
  }
} else {
  await mkdir(out, { recursive: true });
  for (const [name, bytes] of files) await writeFile(join(out, name), bytes);
  for (const [name, bytes] of [...files].sort()) console.log(`${name} ${bytes.length} bytes`);
}
