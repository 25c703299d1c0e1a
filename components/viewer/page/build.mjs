// node build.mjs MODULES OUT: bundles the page with esbuild and makes of it what is linked into the program.
//
//   MODULES   folder whose node_modules holds the packages of package.json
//   OUT       index.html, icon.svg, app.js and app.css, each compressed beside it (.gz); page_data.S, which takes those in; page_files.cpp, which
//             names them; page.d, what the page was made of, for the build tool
//
// Nothing here asks the network, and equal sources give equal bytes.
import { createHash } from "node:crypto";
import { mkdirSync, readFileSync, realpathSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const here = path.dirname(fileURLToPath(import.meta.url));
const [modules, out] = process.argv.slice(2).map((folder) => path.resolve(folder));
if (out === undefined) {
  console.error("usage: node build.mjs MODULES OUT");
  process.exit(2);
}
const types = { ".html": "text/html; charset=utf-8", ".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8", ".svg": "image/svg+xml" };
const esbuild = createRequire(path.join(modules, "of_this_folder.js"))("esbuild");

/** Writes app.js and app.css; returns the files that went into them. */
async function bundle() {
  const result = await esbuild.build({
    absWorkingDir: here,
    entryPoints: { app: "src/main.ts" },
    outdir: out,
    nodePaths: [path.join(modules, "node_modules")],
    bundle: true,
    minify: true,
    format: "esm",
    target: "es2022",
    charset: "utf8",
    legalComments: "none",
    define: { "process.env.NODE_ENV": '"production"' },
    metafile: true,
    logLevel: "warning",
  });
  return {
    inputs: Object.keys(result.metafile.inputs).map((input) => path.resolve(here, input)),
    outputs: Object.keys(result.metafile.outputs).map((output) => path.basename(output)),
  };
}

/** gzip's header names the system it was made on: not here. */
function compressed(bytes) {
  const gzip = gzipSync(bytes, { level: 9 });
  gzip[9] = 255;
  return gzip;
}

function etag(bytes) {
  return createHash("sha256").update(bytes).digest("hex").slice(0, 16);
}

/** The compressed files between labels. The assembler reads them as they are, so that megabytes of page cost no time. */
function assembly(files) {
  const data = files.map(
    ({ gz }, i) =>
      `.globl bw_page_begin_${i}\n.type bw_page_begin_${i}, %object\nbw_page_begin_${i}:\n.incbin "${gz}"\n` +
      `.globl bw_page_end_${i}\n.type bw_page_end_${i}, %object\nbw_page_end_${i}:\n.byte 0\n`,
  );
  return `.section .rodata\n${data.join("")}.section .note.GNU-stack, "", %progbits\n`;
}

function names(files) {
  const labels = files.map((_, i) => `extern const std::uint8_t bw_page_begin_${i}[], bw_page_end_${i}[];\n`);
  const rows = files.map(
    ({ url, type, tag }, i) => `      {"${url}", "${type}", std::span(bw_page_begin_${i}, bw_page_end_${i}), "\\"${tag}\\""},\n`,
  );
  return (
    `#include "components/viewer/adaptor/site.hpp"\n\nextern "C" {\n${labels.join("")}}\n\nnamespace bw::viewer {\n\n` +
    `std::span<const web::SiteFile> page_files() {\n  static const web::SiteFile kFiles[] = {\n${rows.join("")}  };\n` +
    `  return kFiles;\n}\n\n}  // namespace bw::viewer\n`
  );
}

mkdirSync(out, { recursive: true });
const { inputs, outputs } = await bundle();
const copied = ["index.html", "icon.svg"];
for (const name of copied) writeFileSync(path.join(out, name), readFileSync(path.join(here, name)));

const files = [...copied, ...outputs.sort()].map((name) => {
  const bytes = readFileSync(path.join(out, name));
  const gz = path.join(out, `${name}.gz`);
  writeFileSync(gz, compressed(bytes));
  const type = types[path.extname(name)];
  if (type === undefined) throw new Error(`${name}: of what content type is it?`);
  return { url: name === "index.html" ? "/" : `/${name}`, type, gz, tag: etag(bytes) };
});
writeFileSync(path.join(out, "page_data.S"), assembly(files));
writeFileSync(path.join(out, "page_files.cpp"), names(files));
const sources = [...inputs, ...copied.map((name) => path.join(here, name))].map((file) => realpathSync(file).replaceAll(" ", "\\ "));
writeFileSync(path.join(out, "page.d"), `${path.join(out, "page_files.cpp")}: ${sources.join(" ")}\n`);
