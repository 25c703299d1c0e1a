import type { Point } from "../gl/lines";
import { Lines } from "../gl/lines";
import { TopicLayer, type Header, type Legend, type View } from "../layer";

export const PATH = "nav_msgs/msg/Path";

export interface Path {
  header: Header;
  poses: { header: Header; pose: { position: { x: number; y: number; z: number } } }[];
}

/** The way that the global planner found. */
export class PlanLayer extends TopicLayer<Path> {
  readonly id = "plan";
  readonly name = "Global plan";
  readonly legend: Legend = { shape: "line", colors: (palette) => [palette.plan] };
  protected override readonly holdsFor = 3;
  protected override readonly isHeld = true;
  private readonly lines = new Lines(30);

  constructor() {
    super(["/plan", PATH]);
    this.object.add(this.lines.mesh);
  }

  protected draw(path: Path, { palette }: View): void {
    this.lines.clear();
    const points = path.poses.map(({ pose }): Point => [pose.position.x, pose.position.y]);
    this.lines.strip(points, palette.plan, 0, 2);
    this.lines.done();
  }
}
