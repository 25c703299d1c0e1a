// The program foxglove_robot: a test tells the robot what to do and hears what clients made it hear.
import { spawn } from "node:child_process";
import assert from "node:assert/strict";
import { inspect } from "node:util";
import { eventually } from "../../page/process.mjs";

export class Robot {
  static async start(program, ...options) {
    const robot = new Robot(spawn(program, options, { stdio: ["pipe", "pipe", "inherit"] }));
    await eventually("an address", () => robot.lines.length > 0);
    robot.address = robot.lines.shift().replace(/^http/, "ws");
    return robot;
  }

  constructor(child) {
    this.child = child;
    this.lines = [];
    let rest = "";
    child.stdout.on("data", (text) => {
      const parts = (rest + text).split("\n");
      rest = parts.pop();
      this.lines.push(...parts);
    });
    this.ended = new Promise((ended) => child.on("close", ended));
  }

  do(what, order = {}) {
    this.child.stdin.write(JSON.stringify({ do: what, ...order }) + "\n");
  }

  /** The next thing that the robot says it heard must be this. */
  async hears(expected) {
    await eventually(`the robot hears ${JSON.stringify(expected)}`, () => this.lines.length > 0);
    assert.deepEqual(JSON.parse(this.lines.shift()), expected);
  }

  async end() {
    this.child.stdin.end();
    assert.equal(await this.ended, 0);
  }
}

/** What arrives, in its order, to be taken one by one. */
export class Arrivals {
  #queue = [];

  push(arrival) {
    this.#queue.push(arrival);
  }

  get length() {
    return this.#queue.length;
  }

  /** The next one must be this. */
  async next(expected) {
    await eventually(`arrival of ${inspect(expected)}`, () => this.#queue.length > 0);
    assert.deepEqual(this.#queue.shift(), expected);
  }

  async take() {
    await eventually("an arrival", () => this.#queue.length > 0);
    return this.#queue.shift();
  }
}
