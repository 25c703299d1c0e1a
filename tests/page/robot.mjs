// A robot in simulation with its viewer, as a process of its own.
import path from "node:path";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { Program } from "./process.mjs";
import { projectFolder } from "./modules.mjs";

export const program = process.argv[2];
export const hallway = path.join(projectFolder, "config/graphs/hallway.yaml");

export class Robot {
  /** In real time, waiting for goals; `port` 0 is any free one. */
  static async start({ graph = hallway, port = 0, options = [] } = {}) {
    const robot = new Robot(new Program(program, "run", graph, `--page=${port}`, "--stay", "--seed", "7", ...options));
    robot.address = (await robot.process.says(/http:\/\/127\.0\.0\.1:\d+/))[0];
    return robot;
  }

  constructor(process) {
    this.process = process;
  }

  get port() {
    return Number(new URL(this.address).port);
  }

  /** Waits for a goal, counted from 1, to be reached. */
  reaches(goal, seconds = 60) {
    return this.process.says(new RegExp(`goal ${goal}: reached in`), seconds);
  }

  end(signal) {
    return this.process.end(signal);
  }
}

/** A folder of this test's own, which goes when the test ends. */
export function scratch(t) {
  const folder = mkdtempSync(path.join(tmpdir(), "bandwagon_page_"));
  t.after(() => rmSync(folder, { recursive: true }));
  return folder;
}
