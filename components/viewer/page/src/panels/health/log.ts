// Lines of /rosout: kept up to a bound, found by level, node and words.
import type { Seconds } from "../../app";

/** rcl_interfaces/msg/Log */
export interface WireLog {
  stamp: { sec: number; nanosec: number };
  level: number;
  name: string;
  msg: string;
}

export interface Line {
  time: Seconds;
  level: number;
  node: string;
  text: string;
}

export interface LogFilter {
  level: number;
  node: string;
  words: string;
}

export const LOG_LEVELS: readonly [number, string][] = [
  [10, "debug"],
  [20, "info"],
  [30, "warn"],
  [40, "error"],
  [50, "fatal"],
];

export function levelName(level: number): string {
  return LOG_LEVELS.filter(([value]) => value <= level).at(-1)?.[1] ?? "debug";
}

export function lineOf(value: WireLog): Line {
  return { time: value.stamp.sec + value.stamp.nanosec * 1e-9, level: value.level, node: value.name, text: value.msg };
}

export class LogBook {
  private lines: Line[] = [];

  constructor(private readonly most: number) {}

  /** The oldest go. Kept in the order of their stamps: processes are not heard in that of their words. */
  add(lines: readonly Line[]): void {
    if (lines.length === 0) return;
    const isInOrder = lines.every((line, i) => line.time >= ((i === 0 ? this.lines.at(-1) : lines[i - 1])?.time ?? -Infinity));
    this.lines = [...this.lines, ...lines];
    if (!isInOrder) this.lines.sort((a, b) => a.time - b.time);
    this.lines = this.lines.slice(-this.most);
  }

  clear(): void {
    this.lines = [];
  }

  nodes(): string[] {
    return [...new Set(this.lines.map(({ node }) => node))].sort();
  }

  /** The newest `count` up to `until` that the filter lets through, oldest first. */
  find(filter: LogFilter, until: Seconds, count: number): Line[] {
    const words = filter.words.toLowerCase();
    const found: Line[] = [];
    for (let i = this.lines.length - 1; i >= 0 && found.length < count; i--) {
      const line = this.lines[i]!;
      if (line.time > until || line.level < filter.level) continue;
      if (filter.node !== "" && line.node !== filter.node) continue;
      if (words !== "" && !line.text.toLowerCase().includes(words)) continue;
      found.push(line);
    }
    return found.reverse();
  }
}
