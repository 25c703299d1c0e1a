import type { Triangles } from "../gl/triangles";
import type { Point } from "../gl/lines";
import type { Rgba } from "../palette";

const CORNERS = 24;

/** A round body: its top and its darker side. */
export function addBody(
  triangles: Triangles,
  { x, y, radius, height }: { x: number; y: number; radius: number; height: number },
  top: Rgba,
  side: Rgba,
): void {
  const circle: [number, number][] = [];
  for (let i = 0; i <= CORNERS; ++i) {
    const angle = (i / CORNERS) * 2 * Math.PI;
    circle.push([x + radius * Math.cos(angle), y + radius * Math.sin(angle)]);
  }
  extrude(triangles, circle, [x, y], height, top, side);
}

/** `outline` is closed and seen from `middle` star-shaped. */
export function extrude(
  triangles: Triangles,
  outline: readonly (readonly [number, number])[],
  middle: readonly [number, number],
  height: number,
  top: Rgba,
  side: Rgba,
): void {
  const centre: Point = [middle[0], middle[1], height];
  for (let i = 1; i < outline.length; ++i) {
    const [a, b] = [outline[i - 1]!, outline[i]!];
    triangles.quad([a[0], a[1], 0], [b[0], b[1], 0], [b[0], b[1], height], [a[0], a[1], height], side);
    triangles.add(centre, [a[0], a[1], height], [b[0], b[1], height], top);
  }
}
