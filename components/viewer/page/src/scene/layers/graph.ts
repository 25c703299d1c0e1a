import { Discs } from "../gl/discs";
import { Lines, type Point } from "../gl/lines";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { Kind, MARKER_ARRAY, type Marker, type MarkerArray } from "../markers";
import type { Rgba } from "../palette";

/** What slam knows of the drive: submaps, the way through them, and loops by how well they agree with the rest. */
export class GraphLayer extends TopicLayer<MarkerArray> {
  readonly id = "graph";
  readonly name = "Pose graph";
  readonly legend: Legend = {
    shape: "line",
    colors: (palette) => [palette.zoneFree, palette.zoneLimited, palette.zoneStopped],
    note: "loops: agree, strained, taken back",
  };
  protected override readonly holdsFor = Infinity;
  protected override readonly isHeld = true;
  nodes = 0;
  loops = 0;
  private readonly lines = new Lines(26);
  private readonly discs = new Discs(27);

  constructor() {
    super(["/slam_toolbox/graph_visualization", MARKER_ARRAY]);
    this.object.add(this.lines.mesh, this.discs.mesh);
  }

  protected override headerOf(array: MarkerArray): Header | undefined {
    return array.markers[0]?.header;
  }

  protected draw(array: MarkerArray, { palette }: View): void {
    this.lines.clear();
    this.discs.clear();
    this.nodes = 0;
    this.loops = 0;
    for (const marker of array.markers) {
      if (marker.action !== 0) continue;
      if (marker.type === Kind.lineList) this.addLines(marker, palette.plan);
      if (marker.type !== Kind.sphereList) continue;
      for (const { x, y } of marker.points) {
        this.discs.add({ x, y, a: marker.scale.x / 2, b: marker.scale.x / 2 }, palette.robot, palette.halo, 1, 6);
      }
      this.nodes += marker.points.length;
    }
    this.lines.done();
    this.discs.done();
  }

  /** Loops are coloured each by itself, the drive is not. */
  private addLines({ points, colors, scale }: Marker, drive: Rgba): void {
    const at = (i: number): Point => [points[i]!.x, points[i]!.y];
    for (let i = 0; i + 1 < points.length; i += 2) {
      const own = colors[i];
      this.lines.add(at(i), at(i + 1), own ? [own.r, own.g, own.b, own.a] : drive, scale.x, own ? 2.5 : 1.5);
      if (own) this.loops += 1;
    }
  }
}
