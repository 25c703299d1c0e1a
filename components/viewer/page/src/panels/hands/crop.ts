// What of the map is saved: a rectangle under an angle, turned upright. It counts as long as the tool is in the hand.
import { create } from "../dom";
import { offers, type Hand, type HandsContext } from "./context";
import { DragToolButton } from "./drag_tool";
import { CLICK, length, type Point } from "./poses";

/** Of bandwagon_msgs/srv/SaveMapPart: the lower left corner, the direction of the lower side, and both sides [m]. */
export interface MapPart {
  corner: { x: number; y: number; theta: number };
  length: number;
  width: number;
}

function turned({ x, y }: Point, theta: number): Point {
  return { x: x * Math.cos(theta) - y * Math.sin(theta), y: x * Math.sin(theta) + y * Math.cos(theta) };
}

/** The rectangle with this diagonal whose lower side has the direction `theta`. */
export function partOfDiagonal(from: Point, to: Point, theta: number): MapPart {
  const [a, b] = [turned(from, -theta), turned(to, -theta)];
  const corner = turned({ x: Math.min(a.x, b.x), y: Math.min(a.y, b.y) }, theta);
  return { corner: { ...corner, theta }, length: Math.abs(b.x - a.x), width: Math.abs(b.y - a.y) };
}

/** Its outline, closed. */
export function outlineOf({ corner, length, width }: MapPart): Point[] {
  return [[0, 0], [length, 0], [length, width], [0, width], [0, 0]].map(([x, y]) => {
    const offset = turned({ x: x!, y: y! }, corner.theta);
    return { x: corner.x + offset.x, y: corner.y + offset.y };
  });
}

/** Hidden where nobody saves parts of a map. */
export class Crop implements Hand {
  readonly tool: DragToolButton;
  readonly root: HTMLElement;
  private diagonal: [Point, Point] | undefined;
  private readonly angle = create("input", { type: "number", step: "any", value: 0, "data-test": "crop-angle" });

  constructor(
    private readonly context: HandsContext,
    changed: () => void,
  ) {
    this.tool = new DragToolButton(
      context.app,
      {
        label: "Crop map",
        hint: "Drag from corner to corner: Save map then saves that alone, turned upright",
        test: "crop",
        isKept: true,
        onMove: (from, to) => (this.diagonal = [from, to]),
        onRelease: (from, to) => {
          if (length(from, to) < CLICK) this.diagonal = undefined;
        },
        onPut: () => (this.diagonal = undefined),
        stroke: () => (this.part === undefined ? [] : outlineOf(this.part)),
      },
      changed,
    );
    this.angle.addEventListener("input", () => context.app.emit("cursor"));
    this.root = create("div", { class: "row by-numbers" }, create("label", {}, create("span", {}, "Angle of the part [°]"), this.angle));
  }

  /** Undefined: all of the map. */
  get part(): MapPart | undefined {
    const degrees = this.angle.valueAsNumber;
    if (this.diagonal === undefined || !Number.isFinite(degrees)) return undefined;
    return partOfDiagonal(...this.diagonal, (degrees * Math.PI) / 180);
  }

  update(): void {
    const { app } = this.context;
    this.tool.button.hidden = !offers(app, `${app.robot}/map_saver/save_map_part`);
    this.tool.update();
    this.root.hidden = !this.tool.isTaken;
  }
}
