// The time that is looked at.
import type { Cursor, Seconds, Timeline } from "../app";

/** A browser that is slower than this plays slower: leaps would pass over what one looks for. [s] */
const LONGEST_FRAME = 0.25;

/** `tick` moves it on: once per frame of the screen, with the seconds since the last one. */
export class TimeCursor implements Cursor {
  rate = 1;
  isLive: boolean;
  isPlaying = true;
  private where: Seconds | undefined;

  constructor(
    private readonly timeline: () => Timeline,
    private readonly kind: () => "live" | "bag" | undefined,
    private readonly onMove: () => void,
  ) {
    this.isLive = true;
  }

  get time(): Seconds {
    const { begin, end } = this.timeline();
    if (this.isLive) return end;
    return Math.min(Math.max(this.where ?? begin, begin), end);
  }

  /** For another source: a live one is followed, a bag plays from its beginning. */
  reset(): void {
    this.isLive = this.kind() !== "bag";
    this.isPlaying = true;
    this.where = undefined;
    this.onMove();
  }

  seek(time: Seconds): void {
    this.isPlaying = this.isPlaying && !this.isLive;
    this.isLive = false;
    this.where = time;
    this.onMove();
  }

  step(by: Seconds): void {
    const from = this.time;
    this.pause();
    this.seek(from + by);
  }

  play(): void {
    if (this.isLive) return;
    if (this.kind() === "bag" && this.time >= this.timeline().end) this.where = this.timeline().begin;
    this.isPlaying = true;
    this.onMove();
  }

  pause(): void {
    this.where = this.time;
    this.isLive = false;
    this.isPlaying = false;
    this.onMove();
  }

  goLive(): void {
    if (this.kind() === "bag") {
      this.seek(this.timeline().end);
      return;
    }
    this.isLive = true;
    this.isPlaying = true;
    this.onMove();
  }

  tick(elapsed: Seconds): void {
    if (this.isLive || !this.isPlaying) return;
    const { end } = this.timeline();
    this.where = this.time + Math.min(elapsed, LONGEST_FRAME) * this.rate;
    if (this.where >= end) {
      this.where = end;
      if (this.kind() === "live") this.isLive = true;
      else this.isPlaying = false;
    }
    this.onMove();
  }
}
