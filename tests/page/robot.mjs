// A robot in simulation with its viewer, as a process of its own.
import path from "node:path";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { Program } from "./process.mjs";
import { projectFolder } from "./modules.mjs";

export const program = process.argv[2];
export const hallway = path.join(projectFolder, "config/graphs/hallway.yaml");
export const mapDrive = path.join(projectFolder, "config/graphs/map_drive.yaml");

/** The hallway with two people who walk 2 m, which tells them from posts, and stand near its beginning; and nobody else. */
export const quiet = [
  ...["--set", "navigator.goal.enabled=false"],
  ...["--set", "world.people.social.walkers=[]"],
  ...["--set", "world.people.scripted=[{start_time: 2, waypoints: [{x: 5.5, y: 1.5}, {x: 3.5, y: 1.5}]}, " +
    "{start_time: 2, waypoints: [{x: 6.5, y: -1.5}, {x: 4.5, y: -1.5}]}]"],
];

export class Robot {
  /** In real time, waiting for goals; `port` 0 is any free one. */
  static async start({ port = 0, options = quiet, graph = hallway } = {}) {
    const robot = new Robot(new Program(program, "run", graph, `--page=${port}`, "--stay", "--seed", "7", ...options));
    robot.address = (await robot.process.says(/http:\/\/127\.0\.0\.1:\d+\/\?token=[0-9a-f]{32}/))[0];
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
