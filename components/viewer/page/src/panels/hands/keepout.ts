// Keep-out zones: a drag goes round the place, and from then on the robot may not be there; another rubs it out again.
import { groundFrame, expectSuccess, offers, type HandsContext } from "./context";
import { DragToolButton } from "./drag_tool";
import { length, type Point } from "./poses";

const OCCUPIED = 100;
const FREE = 0;
const STEP = 0.03; // [m] between the points of a stroke

/** The line that a drag has drawn, from press to release. */
export class Stroke {
  points: Point[] = [];

  add(from: Point, to: Point): void {
    if (this.points[0] !== from) this.points = [from];
    if (length(this.points.at(-1)!, to) >= STEP) this.points.push(to);
  }
}

/** bandwagon_msgs/srv/DrawPolygon. */
export function drawRequest(frame: string, points: readonly Point[], value: number) {
  return { polygon: { header: { stamp: { sec: 0, nanosec: 0 }, frame_id: frame }, polygon: { points: points.map(({ x, y }) => ({ x, y, z: 0 })) } }, value };
}

/** Hidden where nobody serves a mask. */
export class Keepout {
  readonly draw: DragToolButton;
  readonly erase: DragToolButton;

  constructor(
    private readonly context: HandsContext,
    changed: () => void,
  ) {
    this.draw = this.tool("Keep out", "keepout", "Drag round a place where the robot may not be, or along a line that it may not cross", OCCUPIED, changed);
    this.erase = this.tool("Let in", "let-in", "Drag round what is to be no keep-out zone any more", FREE, changed);
  }

  update(): void {
    for (const tool of [this.draw, this.erase]) {
      tool.button.hidden = !offers(this.context.app, this.service());
      tool.update();
    }
  }

  private tool(label: string, test: string, hint: string, value: number, changed: () => void): DragToolButton {
    const stroke = new Stroke();
    return new DragToolButton(
      this.context.app,
      {
        label,
        hint,
        test,
        isKept: true,
        onMove: (from, to) => stroke.add(from, to),
        onRelease: () => {
          void this.send(label, stroke.points, value);
          stroke.points = [];
        },
        onPut: () => (stroke.points = []),
        stroke: () => stroke.points,
      },
      changed,
    );
  }

  private async send(label: string, points: readonly Point[], value: number): Promise<void> {
    const { app } = this.context;
    if (points.length < 2) return this.context.say(`${label}: drag round the place`, true);
    const done = await this.context.run(label, async () =>
      expectSuccess(await app.hands.call(this.service(), drawRequest(groundFrame(app), points, value))),
    );
    if (done) this.context.say(`${label}: done; Save zones keeps it`);
  }

  private service(): string {
    return `${this.context.app.robot}/keepout_filter_mask_server/draw_polygon`;
  }
}
