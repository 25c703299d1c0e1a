// node build.mjs MODULES OUT: bundles the page with esbuild and makes of it what is linked into the program.
//
//   MODULES   folder whose node_modules holds the packages of package.json
//   OUT       of the page index.html, icon.svg, app.js and app.css, each compressed beside it (.gz); page_data.S, which takes those in;
//             page_files.cpp, which names them; of the page of reports the same as report.*; page.d, what both were made of, for the build tool
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

/** Writes app.* and report.*, scripts and styles; returns the files that went into them. */
async function bundle() {
  const result = await esbuild.build({
    absWorkingDir: here,
    entryPoints: { app: "src/main.ts", report: "src/report/main.ts" },
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
function assembly(site, files) {
  const data = files.map(({ gz }, i) => {
    const [begin, end] = labels(site, i);
    return `.globl ${begin}\n.type ${begin}, %object\n${begin}:\n.incbin "${gz}"\n.globl ${end}\n.type ${end}, %object\n${end}:\n.byte 0\n`;
  });
  return `.section .rodata\n${data.join("")}.section .note.GNU-stack, "", %progbits\n`;
}

function labels(site, i) {
  return [`bw_${site}_begin_${i}`, `bw_${site}_end_${i}`];
}

function names(site, files) {
  const declared = files.map((_, i) => `extern const std::uint8_t ${labels(site, i).join("[], ")}[];\n`);
  const rows = files.map(({ url, type, tag }, i) => `      {"${url}", "${type}", std::span(${labels(site, i).join(", ")}), "\\"${tag}\\""},\n`);
  return (
    `#include "components/viewer/adaptor/site.hpp"\n\nextern "C" {\n${declared.join("")}}\n\nnamespace bw::viewer {\n\n` +
    `std::span<const web::SiteFile> ${site}_files() {\n  static const web::SiteFile kFiles[] = {\n${rows.join("")}  };\n` +
    `  return kFiles;\n}\n\n}  // namespace bw::viewer\n`
  );
}

/** Compresses these files, of which the first is what a browser asks for first, and writes what links them into the program. */
function write(site, [index, ...rest]) {
  const files = [index, ...rest].map((name) => {
    const bytes = readFileSync(path.join(out, name));
    const gz = path.join(out, `${name}.gz`);
    writeFileSync(gz, compressed(bytes));
    const type = types[path.extname(name)];
    if (type === undefined) throw new Error(`${name}: of what content type is it?`);
    return { url: name === index ? "/" : `/${name}`, type, gz, tag: etag(bytes) };
  });
  writeFileSync(path.join(out, `${site}_data.S`), assembly(site, files));
  writeFileSync(path.join(out, `${site}_files.cpp`), names(site, files));
}

mkdirSync(out, { recursive: true });
const { inputs, outputs } = await bundle();
const copied = ["index.html", "report.html", "icon.svg"];
for (const name of copied) writeFileSync(path.join(out, name), readFileSync(path.join(here, name)));
const bundled = (name) => outputs.filter((output) => output.startsWith(`${name}.`)).sort();
write("report", ["report.html", "icon.svg", ...bundled("report")]);
write("page", ["index.html", "icon.svg", ...bundled("app")]);
const sources = [...inputs, ...copied.map((name) => path.join(here, name))].map((file) => realpathSync(file).replaceAll(" ", "\\ "));
writeFileSync(path.join(out, "page.d"), `${path.join(out, "page_files.cpp")}: ${sources.join(" ")}\n`);
