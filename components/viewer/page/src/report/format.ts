// What a report holds: components/lab/report/README.md.

export type Color = "ink" | "grey" | "blue" | "vermilion" | "green" | "purple" | "sky" | "ochre" | "violet" | "red";
export type Dash = "none" | "dashes" | "dots" | "both";
export type Tone = "plain" | "met" | "open" | "missed";
export type Place = [number, number];

export interface Axis {
  label?: string;
  low?: number | null;
  high?: number | null;
  log?: boolean;
}

export interface Series {
  name?: string;
  color: Color;
  dash?: Dash;
  width?: number;
  opacity?: number;
  dots?: boolean;
  /** x, y, x, y, ... of each piece. */
  strokes: number[][];
}

export interface Body {
  name?: string;
  at: Place;
  radius: number;
  color: Color;
  label?: string;
  arrow?: Place;
}

export type Symbol = "dot" | "ring" | "square" | "triangle" | "cross";

export interface Mark {
  name?: string;
  at: Place;
  symbol: Symbol;
  color: Color;
  label?: string;
}

export interface Area {
  name?: string;
  outline: number[];
  color: Color;
  dash?: Dash;
  shade?: boolean;
}

export interface Limit {
  value: number;
  label: string;
}

export interface Chart {
  kind: "chart";
  title: string;
  x: Axis;
  y: Axis;
  floor?: boolean;
  /** Of what the axes enclose [px]. */
  height?: number;
  series?: Series[];
  spans?: { from: number; to: number; label: string }[];
  limits?: Limit[];
  bodies?: Body[];
  marks?: Mark[];
  areas?: Area[];
  /** x, y, x, y from end to end. */
  walls?: number[][];
  /** The lower left and the upper right corner. */
  blocks?: number[][];
}

export interface Interval {
  mean: number | null;
  low: number | null;
  high: number | null;
}

export interface Column {
  label: string;
  color: Color;
  runs?: (number | null)[];
  measured?: Interval;
  published?: number | null;
}

export interface Columns {
  kind: "columns";
  title: string;
  y: Axis;
  measured: string;
  runs: string;
  columns: Column[];
  limits?: Limit[];
}

export type Picture = Chart | Columns;

export type Cell = string | number | { value: number | null; low?: number | null; high?: number | null } | { text: string; tone: Tone };

export interface Table {
  kind: "table";
  columns: { name: string; decimals?: number }[];
  rows: Cell[][];
}

export interface Figure {
  kind: "figure";
  title: string;
  caption: string;
  columns: number;
  id?: string;
  pictures: Picture[];
}

export type Block =
  | { kind: "heading"; level: number; text: string }
  | { kind: "text"; text: string }
  | { kind: "list"; lead: string; items: string[] }
  | { kind: "outcome"; tone: Tone; lines: string[]; missed: string[] }
  | Table
  | Figure;

export interface Report {
  report: number;
  title: string;
  blocks: Block[];
}

export const VERSION = 1;
