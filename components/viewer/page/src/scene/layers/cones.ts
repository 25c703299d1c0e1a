import { Lines } from "../gl/lines";
import { Triangles } from "../gl/triangles";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { Kind, MARKER_ARRAY, markersOf, type MarkerArray } from "../markers";
import { withOpacity } from "../palette";
import { pointsOf } from "./candidates";

/** Velocities that lead into people, from the robot at 1 m for 1 m/s, and the best one outside of them. */
export class ConesLayer extends TopicLayer<MarkerArray> {
  readonly id = "cones";
  readonly name = "Velocity cones";
  readonly legend: Legend = { shape: "area", colors: (palette) => [palette.cones], note: "1 m for 1 m/s" };
  protected override readonly holdsFor = 0.6;
  private readonly areas = new Triangles(25);
  private readonly lines = new Lines(26);

  constructor() {
    super(["/local_planner_markers", MARKER_ARRAY]);
    this.object.add(this.areas.mesh, this.lines.mesh);
  }

  protected override headerOf(array: MarkerArray): Header | undefined {
    return array.markers.find((marker) => marker.action === 0)?.header;
  }

  protected draw(array: MarkerArray, { palette }: View): void {
    this.areas.clear();
    this.lines.clear();
    for (const marker of markersOf(array, "velocity_cones")) {
      const points = pointsOf(marker);
      if (marker.type === Kind.triangleList)
        for (let i = 0; i + 2 < points.length; i += 3) this.areas.add(points[i]!, points[i + 1]!, points[i + 2]!, withOpacity(palette.cones, 0.13));
      else for (let i = 0; i + 1 < points.length; i += 2) this.lines.add(points[i]!, points[i + 1]!, withOpacity(palette.cones, 0.8), 0, 1.5);
    }
    for (const marker of markersOf(array, "velocity_wanted")) {
      const [from, to] = pointsOf(marker);
      if (from && to) this.lines.arrow(from, to, palette.wanted, 0, 2, 0.12);
    }
    this.areas.done();
    this.lines.done();
  }
}
