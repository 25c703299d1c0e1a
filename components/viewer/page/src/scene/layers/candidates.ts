import { Labels } from "../gl/labels";
import { Lines, type Point } from "../gl/lines";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { MARKER_ARRAY, markersOf, type Marker, type MarkerArray } from "../markers";
import type { Palette, Rgba } from "../palette";

/** The other candidates, a colour for each class; label and cost at their middle. The one that is driven is the band. */
export class CandidatesLayer extends TopicLayer<MarkerArray> {
  readonly id = "candidates";
  readonly name = "Other candidates";
  readonly legend: Legend = { shape: "line", colors: (palette) => palette.classes.slice(0, 3), note: "by class, with cost" };
  protected override readonly holdsFor = 0.6;
  private readonly lines = new Lines(40);
  private readonly labels = new Labels(91);
  count = 0;

  constructor() {
    super(["/local_planner_markers", MARKER_ARRAY]);
    this.object.add(this.lines.mesh, this.labels.mesh);
  }

  protected override headerOf(array: MarkerArray): Header | undefined {
    return array.markers.find((marker) => marker.action === 0)?.header;
  }

  protected draw(array: MarkerArray, { palette }: View): void {
    this.lines.clear();
    this.labels.clear();
    const lines = markersOf(array, "candidates");
    this.count = lines.length;
    for (const line of lines) {
      if (isChosen(line)) continue;
      const label = labelOf(line, array);
      this.lines.strip(pointsOf(line), classColor(label?.text ?? "", palette), 0, 2);
    }
    for (const label of markersOf(array, "candidate_labels")) {
      const { x, y } = label.pose.position;
      const color = isChosen(label) ? palette.text : classColor(label.text, palette);
      this.labels.add([x, y, 0.2], label.text, color, palette.halo, isChosen(label) ? 16 : 0);
    }
    this.lines.done();
    this.labels.done();
  }
}

export function pointsOf({ points }: Marker): Point[] {
  return points.map(({ x, y }): Point => [x, y]);
}

/** The planner draws the one that it drives green, the others grey. */
export function isChosen({ color }: Marker): boolean {
  return color.g > color.r + 0.2;
}

/** A label lies at the middle point of its line. */
function labelOf(line: Marker, array: MarkerArray): Marker | undefined {
  const middle = line.points[Math.floor(line.points.length / 2)];
  return markersOf(array, "candidate_labels").find(
    ({ pose }) => middle && pose.position.x === middle.x && pose.position.y === middle.y,
  );
}

/** Of the class in "LR 12.30"; the same class has the same colour at all times. */
export function classColor(label: string, palette: Palette): Rgba {
  const name = label.split(" ")[0]!;
  let hash = 0;
  for (const letter of name) hash = (hash * 31 + letter.charCodeAt(0)) >>> 0;
  return palette.classes[hash % palette.classes.length]!;
}
