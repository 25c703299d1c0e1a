// The packages that launch_scripts/setup.sh put into build/node; they do not lie above the tests, where Node.js would look for them.
import { createRequire } from "node:module";
import path from "node:path";
import { fileURLToPath } from "node:url";

export const modulesFolder = path.resolve(process.env.BANDWAGON_NODE_MODULES);
export const require = createRequire(path.join(modulesFolder, "of_this_folder.js"));
export const projectFolder = fileURLToPath(new URL("../..", import.meta.url));
export const pageFolder = path.join(projectFolder, "components/viewer/page");
