// Driving by hand with a dead man's switch: commands go out as long as something is held, and nothing else makes them go on. The robot stands
// 0.2 s after the last one even if the page dies (components/twist_mux); letting go says zero at once.

export type Direction = "forward" | "backward" | "left" | "right";

export interface Twist {
  linear: { x: number; y: number; z: number };
  angular: { x: number; y: number; z: number };
}

export interface Speeds {
  linear: number; // m/s
  angular: number; // rad/s
}

/** Commands each 66 ms: 15 Hz, three of them within the 0.2 s that one counts. */
export const PERIOD_MS = 66;

export interface Clockwork {
  every(ms: number, tick: () => void): () => void;
}

export class Driver {
  private readonly held = new Map<string, Direction>();
  private stopClock: (() => void) | undefined;
  private waiting = 0;

  /** `send` may fail: then everything is let go of and `failed` hears why. */
  constructor(
    private readonly send: (twist: Twist) => Promise<void>,
    private readonly speeds: () => Speeds,
    private readonly clockwork: Clockwork,
    private readonly failed: (reason: unknown) => void,
  ) {}

  get isDriving(): boolean {
    return this.held.size > 0;
  }

  holds(direction: Direction): boolean {
    return [...this.held.values()].includes(direction);
  }

  /** `what` is held: a key, a button, a finger. */
  press(what: string, direction: Direction): void {
    if (this.held.get(what) === direction) return;
    this.held.set(what, direction);
    this.tell();
    this.stopClock ??= this.clockwork.every(PERIOD_MS, () => this.repeat());
  }

  release(what: string): void {
    if (!this.held.delete(what)) return;
    if (this.held.size === 0) this.stop();
    else this.tell();
  }

  releaseAll(): void {
    if (this.held.size === 0) return;
    this.held.clear();
    this.stop();
  }

  private stop(): void {
    this.stopClock?.();
    this.stopClock = undefined;
    this.tell();
  }

  /** A connection that does not take commands any more gets no queue of them: late ones would drive on. */
  private repeat(): void {
    if (this.waiting < 2) this.tell();
  }

  private tell(): void {
    this.waiting++;
    this.send(this.command()).then(
      () => void this.waiting--,
      (reason) => {
        this.waiting--;
        const wasDriving = this.isDriving;
        this.held.clear();
        this.stopClock?.();
        this.stopClock = undefined;
        if (wasDriving) this.failed(reason);
      },
    );
  }

  private command(): Twist {
    const { linear, angular } = this.speeds();
    const along = Number(this.holds("forward")) - Number(this.holds("backward"));
    const turn = Number(this.holds("left")) - Number(this.holds("right"));
    return { linear: { x: along * linear, y: 0, z: 0 }, angular: { x: 0, y: 0, z: turn * angular } };
  }
}

/** Keys by their place on the keyboard, whatever is printed on them. */
export const DIRECTION_OF_KEY: Readonly<Record<string, Direction>> = {
  KeyW: "forward",
  ArrowUp: "forward",
  KeyS: "backward",
  ArrowDown: "backward",
  KeyA: "left",
  ArrowLeft: "left",
  KeyD: "right",
  ArrowRight: "right",
};
