import { Labels } from "../gl/labels";
import { Lines } from "../gl/lines";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { Kind, MARKER_ARRAY, type Marker, type MarkerArray } from "../markers";
import type { Palette, Rgba } from "../palette";
import { pointsOf } from "./candidates";

const SILENT = "command_silent"; // nothing is asked, so nothing is limited

/** What the collision monitor keeps free: idle, slowing down, stopping; and why. */
export class ZonesLayer extends TopicLayer<MarkerArray> {
  readonly id = "zones";
  readonly name = "Collision monitor";
  readonly legend: Legend = {
    shape: "line",
    colors: (palette) => [palette.zoneFree, palette.zoneLimited, palette.zoneStopped],
    note: "free, limits, stops",
  };
  protected override readonly holdsFor = 1;
  protected override readonly isHeld = true;
  private readonly lines = new Lines(55);
  private readonly labels = new Labels(93);

  constructor() {
    super(["/collision_monitor_markers", MARKER_ARRAY]);
    this.object.add(this.lines.mesh, this.labels.mesh);
  }

  protected override headerOf(array: MarkerArray): Header | undefined {
    return array.markers[0]?.header;
  }

  protected draw(array: MarkerArray, { palette }: View): void {
    this.lines.clear();
    this.labels.clear();
    const isSilent = array.markers.some(({ text }) => text === SILENT);
    for (const marker of array.markers) {
      const { x, y, z } = marker.pose.position;
      const color = isSilent ? palette.zoneIdle : stateColor(marker, palette);
      if (marker.type === Kind.text && marker.text !== SILENT) this.labels.add([x, y, z], marker.text, color, palette.halo, 24);
      if (marker.type === Kind.lineStrip) this.lines.strip(pointsOf(marker), color, 0, 1.8);
    }
    this.lines.done();
    this.labels.done();
  }
}

/** The monitor paints free green, limiting yellow, stopping red, and grey what decides nothing; ours are easier to tell apart. */
function stateColor({ color: { r, g, b } }: Marker, palette: Palette): Rgba {
  if (Math.max(r, g, b) - Math.min(r, g, b) < 0.2) return palette.zoneIdle;
  if (r < 0.5) return palette.zoneFree;
  return g > 0.5 ? palette.zoneLimited : palette.zoneStopped;
}
