// Programs that a test starts, and waiting for what they do.
import { spawn } from "node:child_process";

/** Polls until `seen` gives something true, which is returned; after `seconds` the test fails with what `what` says. */
export async function eventually(what, seen, seconds = 30) {
  const end = Date.now() + seconds * 1000;
  for (;;) {
    const found = await seen();
    if (found) return found;
    if (Date.now() > end) throw new Error(`after ${seconds} s not: ${typeof what === "function" ? await what() : what}`);
    await new Promise((later) => setTimeout(later, 50));
  }
}

export class Program {
  constructor(command, ...arguments_) {
    this.said = "";
    this.status = undefined;
    this.child = spawn(command, arguments_, {
      stdio: ["ignore", "pipe", "pipe"],
    });
    for (const stream of [this.child.stdout, this.child.stderr]) stream.on("data", (text) => (this.said += text));
    this.ended = new Promise((ended) => this.child.on("close", (code, signal) => ended((this.status = code ?? signal))));
  }

  get pid() {
    return this.child.pid;
  }

  /** Waits for words of the program; returns the match. */
  says(pattern, seconds = 30) {
    return eventually(
      () => `${pattern} in\n${this.said}`,
      () => {
        const match = this.said.match(pattern);
        if (!match && this.status !== undefined) throw new Error(`it ended with ${this.status}:\n${this.said}`);
        return match;
      },
      seconds,
    );
  }

  /** Ends it by its own id and waits; returns its exit status, or the signal that ended it. */
  async end(signal = "SIGINT") {
    if (this.status === undefined) this.child.kill(signal);
    return this.ended;
  }
}

/** Runs a program to its end; returns what it said. */
export async function run(command, ...arguments_) {
  const program = new Program(command, ...arguments_);
  const status = await program.ended;
  if (status !== 0) throw new Error(`${[command, ...arguments_].join(" ")} ended with ${status}:\n${program.said}`);
  return program.said;
}
