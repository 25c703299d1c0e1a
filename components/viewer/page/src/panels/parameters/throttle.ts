// A slider says more than a robot has to hear: one request at a time, not more often than each `period`, and the last value always.

export interface Timer {
  now(): number; // ms
  after(ms: number, then: () => void): void;
}

export class Throttle<T> {
  private pending: { value: T } | undefined;
  private isBusy = false;
  private last = -Infinity;

  constructor(
    private readonly send: (value: T) => Promise<unknown>,
    private readonly period: number,
    private readonly timer: Timer,
  ) {}

  /** Sent now, or when it may be; a newer value takes its place. */
  give(value: T): void {
    this.pending = { value };
    if (!this.isBusy) this.next();
  }

  private next(): void {
    if (this.pending === undefined) {
      this.isBusy = false;
      return;
    }
    this.isBusy = true;
    const wait = this.last + this.period - this.timer.now();
    if (wait > 0) return this.timer.after(wait, () => this.next());
    const { value } = this.pending;
    this.pending = undefined;
    this.last = this.timer.now();
    const next = () => this.next();
    this.send(value).then(next, next);
  }
}
