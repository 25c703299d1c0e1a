// TypeScript's checker over the page; the build only strips the types.
import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync, symlinkSync } from "node:fs";
import path from "node:path";
import test from "node:test";
import { modulesFolder, pageFolder, require } from "./modules.mjs";

test("the page's types are right", (t) => {
  // Seen through a link in the folder of the packages, the sources have them above themselves, where the checker looks.
  const seen = mkdtempSync(path.join(modulesFolder, "types_"));
  t.after(() => rmSync(seen, { recursive: true }));
  symlinkSync(pageFolder, path.join(seen, "page"));
  const arguments_ = [require.resolve("typescript/bin/tsc"), "--noEmit", "--preserveSymlinks", "-p", path.join(seen, "page")];
  try {
    execFileSync(process.execPath, arguments_, { encoding: "utf8" });
  } catch (error) {
    throw new Error(error.stdout);
  }
});
