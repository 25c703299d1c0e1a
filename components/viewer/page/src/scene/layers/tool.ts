import type { Tool } from "../../app";
import { Discs } from "../gl/discs";
import { Labels } from "../gl/labels";
import { Lines } from "../gl/lines";
import type { Palette } from "../palette";
import { Group } from "three";

interface At {
  x: number;
  y: number;
}

const ARROW = 0.7; // [m] of a pose that was placed

/** What the hand draws: the arrow or line under way, and the arrows that the tool has placed. */
export class ToolOverlay {
  readonly object = new Group();
  drag: { from: At; to: At } | undefined;
  private readonly discs = new Discs(70);
  private readonly lines = new Lines(71);
  private readonly labels = new Labels(95);

  constructor() {
    for (const part of [this.discs, this.lines, this.labels]) this.object.add(part.mesh);
  }

  update(tool: Tool | undefined, palette: Palette): void {
    for (const part of [this.discs, this.lines, this.labels]) part.clear();
    tool?.placed?.forEach(({ x, y, theta }, i) => {
      this.arrow({ x, y }, { x: x + ARROW * Math.cos(theta), y: y + ARROW * Math.sin(theta) }, palette);
      this.labels.add([x, y], `${i + 1}`, palette.text, palette.halo, -16);
    });
    if (tool?.stroke) this.lines.strip(tool.stroke.map(({ x, y }) => [x, y] as const), palette.goal, 0, 3);
    else if (tool && this.drag) this.arrow(this.drag.from, this.drag.to, palette);
    for (const part of [this.discs, this.lines, this.labels]) part.done();
  }

  private arrow(from: At, to: At, palette: Palette): void {
    this.discs.add({ ...from, a: 0.1, b: 0.1 }, palette.goal, palette.halo, 1.5, 10);
    if (Math.hypot(to.x - from.x, to.y - from.y) > 0.05) this.lines.arrow([from.x, from.y], [to.x, to.y], palette.goal, 0, 3, 0.2);
  }
}
