// The way of an arrow from one box to another: leaves and meets the edges that face each other, in a soft curve.
import type { Rectangle } from "./layout";

interface Point {
  x: number;
  y: number;
}

export function arrowPath(from: Rectangle, to: Rectangle): string {
  const [a, b] = [middle(from), middle(to)];
  const isSideways = Math.abs(b.x - a.x) > Math.abs(b.y - a.y);
  // Those of one column, and not neighbours, go round the boxes between them.
  const isAround = Math.abs(b.x - a.x) < 1 && Math.abs(b.y - a.y) > from.height * 1.8;
  if (isAround) {
    const side = b.y > a.y ? 1 : -1;
    const edge = (box: Rectangle) => ({ x: side > 0 ? box.x + box.width : box.x, y: middle(box).y });
    return curve(edge(from), { x: edge(from).x + 28 * side, y: a.y }, { x: edge(to).x + 28 * side, y: b.y }, edge(to));
  }
  if (isSideways) {
    const direction = Math.sign(b.x - a.x);
    const [start, end] = [
      { x: a.x + (direction * from.width) / 2, y: a.y },
      { x: b.x - (direction * to.width) / 2, y: b.y },
    ];
    const bend = Math.max(12, Math.abs(end.x - start.x) / 2) * direction;
    return curve(start, { x: start.x + bend, y: start.y }, { x: end.x - bend, y: end.y }, end);
  }
  const direction = Math.sign(b.y - a.y) || 1;
  const [start, end] = [
    { x: a.x, y: a.y + (direction * from.height) / 2 },
    { x: b.x, y: b.y - (direction * to.height) / 2 },
  ];
  const bend = Math.max(8, Math.abs(end.y - start.y) / 2) * direction;
  return curve(start, { x: start.x, y: start.y + bend }, { x: end.x, y: end.y - bend }, end);
}

function middle({ x, y, width, height }: Rectangle): Point {
  return { x: x + width / 2, y: y + height / 2 };
}

function curve(...points: Point[]): string {
  const [start, ...rest] = points.map(({ x, y }) => `${Math.round(x * 10) / 10},${Math.round(y * 10) / 10}`);
  return `M${start} C${rest.join(" ")}`;
}
