// The page's packages and its build: what a machine with Debian's Node.js 18 and npm 9 can install, and twice the same bytes without a network.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import test from "node:test";
import { modulesFolder, pageFolder, require } from "./modules.mjs";

const lock = JSON.parse(readFileSync(path.join(pageFolder, "package-lock.json"), "utf8"));
const packages = Object.entries(lock.packages).filter(([name]) => name !== "");

test("the lock file pins every package by its hash and names no address", () => {
  // npm 7 to 9 write version 3; older ones cannot read it, Debian's has 9.
  assert.equal(lock.lockfileVersion, 3);
  assert.ok(packages.length > 0);
  for (const [name, entry] of packages) {
    assert.match(entry.integrity ?? "", /^sha512-/, name);
    assert.equal(entry.resolved, undefined, `${name} has an address: npm config set omit-lockfile-registry-resolved true`);
  }
});

test("every package runs on Debian's Node.js 18.20.4", () => {
  const { satisfies } = require("semver");
  for (const [name, entry] of packages) {
    const engine = entry.engines?.node;
    assert.ok(engine === undefined || satisfies("18.20.4", engine), `${name} ${entry.version} wants Node.js ${engine}`);
  }
});

test("the build is the same twice, without a network, and the page takes at most 450 kB", (t) => {
  const outs = [0, 1].map(() => mkdtempSync(path.join(tmpdir(), "bandwagon_page_")));
  t.after(() => outs.forEach((out) => rmSync(out, { recursive: true })));
  for (const out of outs) {
    // Whoever asked for a package would meet a proxy that nobody serves.
    const env = { PATH: process.env.PATH, http_proxy: "http://127.0.0.1:9", https_proxy: "http://127.0.0.1:9" };
    execFileSync(process.execPath, [path.join(pageFolder, "build.mjs"), modulesFolder, out], { env, stdio: "inherit" });
  }
  const compressed = readdirSync(outs[0]).filter((name) => name.endsWith(".gz"));
  assert.ok(compressed.includes("index.html.gz") && compressed.includes("app.js.gz"), compressed.join());
  const bytes = (out, name) => readFileSync(path.join(out, name));
  for (const name of compressed) assert.deepEqual(bytes(outs[0], name), bytes(outs[1], name), name);
  const sizeOf = (names) => names.reduce((sum, name) => sum + bytes(outs[0], name).length, 0);
  const total = sizeOf(compressed.filter((name) => !name.startsWith("report.")));
  console.log(`the page: ${total} bytes compressed`);
  assert.ok(total <= 450_000, `${total} bytes are more than the 450 kB that were asked for`);
  // It stands uncompressed in every report.
  const report = ["report.html", "report.js", "report.css"].reduce((sum, name) => sum + bytes(outs[0], name).length, 0);
  console.log(`the page of reports: ${report} bytes`);
  assert.ok(report <= 100_000, `${report} bytes are more than 100 kB`);
});
