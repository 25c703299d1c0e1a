import { Discs } from "../gl/discs";
import { Lines } from "../gl/lines";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { withOpacity } from "../palette";
import { yawOf, type Quaternion } from "../../source/transforms";

interface NavigationStatus {
  header: Header;
  status: number;
  goal: { header: Header; pose: { position: { x: number; y: number }; orientation: Quaternion } };
  xy_tolerance: number;
}

const UNDER_WAY = [1, 2, 3]; // accepted, executing, canceling

/** The goal in hand, and within what it counts as reached. */
export class GoalLayer extends TopicLayer<NavigationStatus> {
  readonly id = "goal";
  readonly name = "Goal";
  readonly legend: Legend = { shape: "ring", colors: (palette) => [palette.goal], note: "ring: its tolerance" };
  protected override readonly isHeld = true;
  private readonly discs = new Discs(58);
  private readonly lines = new Lines(58);

  constructor() {
    super(["/navigation_status", "bandwagon_msgs/msg/NavigationStatus"]);
    this.object.add(this.discs.mesh, this.lines.mesh);
  }

  protected override headerOf({ status, goal }: NavigationStatus): Header | undefined {
    return UNDER_WAY.includes(status) ? goal.header : undefined;
  }

  protected draw({ goal, xy_tolerance }: NavigationStatus, { palette }: View): void {
    this.discs.clear();
    this.lines.clear();
    const { position, orientation } = goal.pose;
    const { x, y } = position;
    const yaw = yawOf(orientation);
    this.discs.add({ x, y, a: xy_tolerance, b: xy_tolerance }, withOpacity(palette.goal, 0.12), palette.goal, 1.5, 12);
    this.discs.add({ x, y, a: 0.06, b: 0.06 }, palette.goal, undefined, 0, 6);
    this.lines.arrow([x, y], [x + 0.7 * Math.cos(yaw), y + 0.7 * Math.sin(yaw)], palette.goal, 0, 2.5, 0.2);
    this.discs.done();
    this.lines.done();
  }
}
