// Where the boxes stand: processes as frames, in them lanes, in those components. Side by side where there is room, below one another where not.
import type { Component } from "./diagnostics";

export interface Rectangle {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface Group extends Rectangle {
  name: string;
  kind: "process" | "lane";
}

export interface Layout {
  width: number;
  height: number;
  groups: Group[];
  boxes: Map<string, Rectangle>;
}

export const BOX = { width: 152, height: 66 };
const GAP = 8;
const HEAD = { process: 20, lane: 15 };
/** Between processes, for arrows. */
const AISLE = { narrow: 10, wide: 44 };

interface Process {
  name: string;
  lanes: { name: string; components: Component[] }[];
}

export function processesOf(components: readonly Component[]): Process[] {
  const processes: Process[] = [];
  for (const component of components) {
    const process = found(processes, component.process || "elsewhere", (name) => ({ name, lanes: [] }));
    found(process.lanes, component.lane || "", (name) => ({ name, components: [] })).components.push(component);
  }
  return processes;
}

export function layoutOf(components: readonly Component[], width: number): Layout {
  const processes = processesOf(components);
  const columns = columnsOf(processes, width);
  const layout: Layout = { width, height: 0, groups: [], boxes: new Map() };
  let x = 0;
  let y = 0;
  processes.forEach((process, i) => {
    const frame = place(process, columns?.[i] ?? fitting(width), x, y, layout);
    layout.height = Math.max(layout.height, frame.y + frame.height);
    if (columns === undefined) y = layout.height + AISLE.narrow;
    else x += frame.width + AISLE.wide;
  });
  if (columns === undefined) for (const group of layout.groups) if (group.kind === "process") group.width = width;
  return layout;
}

function found<T extends { name: string }>(all: T[], name: string, make: (name: string) => T): T {
  let each = all.find((one) => one.name === name);
  if (each === undefined) all.push((each = make(name)));
  return each;
}

/** A process of so many columns is that wide. */
function frameWidth(columns: number): number {
  return columns * (BOX.width + GAP) + GAP;
}

function fitting(width: number): number {
  return Math.max(1, Math.floor((width - GAP) / (BOX.width + GAP)));
}

/** Columns of boxes for each process side by side; undefined: there is no room. The highest gets one more as long as there is some. */
function columnsOf(processes: readonly Process[], width: number): number[] | undefined {
  const columns = processes.map(() => 1);
  const needed = () => columns.reduce((sum, count) => sum + frameWidth(count) + AISLE.wide, -AISLE.wide);
  if (processes.length < 2 || needed() > width) return undefined;
  const rows = (i: number) => place(processes[i]!, columns[i]!, 0, 0, { width, height: 0, groups: [], boxes: new Map() }).height;
  for (;;) {
    const highest = processes.map((_, i) => i).sort((a, b) => rows(b) - rows(a))[0]!;
    columns[highest]!++;
    if (needed() <= width && columns[highest]! <= 3) continue;
    columns[highest]!--;
    return columns;
  }
}

/** Lanes flow into rows; one that is longer than a row breaks. Adds to `layout`, returns the frame. */
function place(process: Process, columns: number, x: number, y: number, layout: Layout): Group {
  const frame: Group = { name: process.name, kind: "process", x, y, width: frameWidth(columns), height: 0 };
  layout.groups.push(frame);
  let column = 0;
  let top = y + HEAD.process;
  let rowHeight = 0;
  for (const lane of process.lanes) {
    const across = Math.min(columns, lane.components.length);
    const down = Math.ceil(lane.components.length / across);
    if (column + across > columns) {
      top += rowHeight;
      column = rowHeight = 0;
    }
    const left = x + GAP + column * (BOX.width + GAP);
    const height = HEAD.lane + down * (BOX.height + GAP);
    layout.groups.push({ name: lane.name, kind: "lane", x: left, y: top, width: across * (BOX.width + GAP) - GAP, height: height - GAP });
    lane.components.forEach((component, i) =>
      layout.boxes.set(component.name, {
        ...BOX,
        x: left + (i % across) * (BOX.width + GAP),
        y: top + HEAD.lane + Math.floor(i / across) * (BOX.height + GAP),
      }),
    );
    column += across;
    rowHeight = Math.max(rowHeight, height);
  }
  frame.height = top + rowHeight - y;
  return frame;
}
