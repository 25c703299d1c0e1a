// The page's own tests, components/viewer/page/test/**/*.test.ts: bundled as the page is, and run by Node.js.
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import path from "node:path";
import test, { after } from "node:test";
import { spawnSync } from "node:child_process";
import assert from "node:assert/strict";
import { modulesFolder, pageFolder, require } from "./modules.mjs";

function testsBelow(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const place = path.join(folder, entry.name);
    return entry.isDirectory() ? testsBelow(place) : place.endsWith(".test.ts") ? [place] : [];
  });
}

// Where Node.js finds the packages that are not bundled.
const out = mkdtempSync(path.join(modulesFolder, "units_"));
const folder = path.join(pageFolder, "test");
const sources = testsBelow(folder);
assert.ok(sources.length > 0, `no tests in ${folder}`);
require("esbuild").buildSync({
  entryPoints: sources,
  outbase: folder,
  outdir: out,
  outExtension: { ".js": ".mjs" },
  nodePaths: [path.join(modulesFolder, "node_modules")],
  bundle: true,
  platform: "node",
  format: "esm",
  packages: "external",
  loader: { ".css": "empty" },
  sourcemap: "inline",
  logLevel: "warning",
});

for (const source of sources) {
  const name = path.relative(folder, source);
  test(name, () => {
    const env = { ...process.env, BANDWAGON_PROJECT: path.resolve(pageFolder, "../../..") };
    delete env.NODE_TEST_CONTEXT; // of this process: its child reports to people
    const { status, stdout, stderr } = spawnSync(process.execPath, ["--enable-source-maps", path.join(out, name.replace(/\.ts$/, ".mjs"))], { encoding: "utf8", env });
    assert.equal(status, 0, stdout + stderr);
    console.log(`${name}: ${stdout.match(/^# pass \d+/m)?.[0].slice(2) ?? "?"}`);
  });
}
after(() => rmSync(out, { recursive: true }));
