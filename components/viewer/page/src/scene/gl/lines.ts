// Lines as wide as they are on the ground, never thinner than some pixels, with smooth edges and round ends.
import type { Rgba } from "../palette";
import { Instances } from "./instances";

const VERTEX = `
attribute vec3 start;
attribute vec3 end;
attribute vec4 startColor;
attribute vec4 endColor;
attribute vec2 width; // on the ground [m], at least [px]
uniform vec2 viewport;
uniform float pixelRatio;
varying vec4 vColor;
varying vec2 vAt; // [px] along and across
varying float vLength;
varying float vHalf;

const float NEAR = 0.05;

void main() {
  vec4 a = projectionMatrix * modelViewMatrix * vec4(start, 1.0);
  vec4 b = projectionMatrix * modelViewMatrix * vec4(end, 1.0);
  if (a.w < NEAR && b.w < NEAR) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  if (a.w < NEAR) a = mix(a, b, (NEAR - a.w) / (b.w - a.w));
  if (b.w < NEAR) b = mix(b, a, (NEAR - b.w) / (a.w - b.w));
  vec2 pa = a.xy / a.w * viewport * 0.5;
  vec2 pb = b.xy / b.w * viewport * 0.5;
  float w = mix(a.w, b.w, position.x);
  float perMetre = projectionMatrix[1][1] * viewport.y * 0.5 / w;
  vHalf = max(width.x * perMetre, width.y * pixelRatio) * 0.5;
  vLength = distance(pa, pb);
  vec2 along = vLength > 1e-4 ? (pb - pa) / vLength : vec2(1.0, 0.0);
  float reach = vHalf + 1.0;
  vec2 at = mix(pa, pb, position.x) + along * (position.x * 2.0 - 1.0) * reach + vec2(-along.y, along.x) * position.y * reach;
  vAt = vec2(position.x * vLength + (position.x * 2.0 - 1.0) * reach, position.y * reach);
  vColor = mix(startColor, endColor, position.x);
  gl_Position = vec4(at / (viewport * 0.5), mix(a.z / a.w, b.z / b.w, position.x), 1.0);
}`;

const FRAGMENT = `
varying vec4 vColor;
varying vec2 vAt;
varying float vLength;
varying float vHalf;
void main() {
  float off = length(vec2(vAt.x - clamp(vAt.x, 0.0, vLength), vAt.y));
  float cover = clamp(vHalf + 0.5 - off, 0.0, 1.0);
  if (cover <= 0.0) discard;
  gl_FragColor = vec4(vColor.rgb, vColor.a * cover);
}`;

export type Point = readonly [x: number, y: number, z?: number];

export class Lines {
  private readonly instances: Instances;

  constructor(order: number) {
    const layout = { start: 3, end: 3, startColor: 4, endColor: 4, width: 2 };
    this.instances = new Instances(layout, { vertex: VERTEX, fragment: FRAGMENT }, order);
  }

  get mesh() {
    return this.instances.mesh;
  }

  clear(): void {
    this.instances.clear();
  }

  add(from: Point, to: Point, color: Rgba, metres: number, pixels: number, endColor = color): void {
    this.instances.add(from[0], from[1], from[2] ?? 0, to[0], to[1], to[2] ?? 0, ...color, ...endColor, metres, pixels);
  }

  strip(points: readonly Point[], color: Rgba, metres: number, pixels: number): void {
    for (let i = 1; i < points.length; ++i) this.add(points[i - 1]!, points[i]!, color, metres, pixels);
  }

  /** With a head of two strokes. */
  arrow(from: Point, to: Point, color: Rgba, metres: number, pixels: number, head: number): void {
    const angle = Math.atan2(to[1] - from[1], to[0] - from[0]);
    this.add(from, to, color, metres, pixels);
    for (const side of [2.6, -2.6]) {
      const tip: Point = [to[0] + head * Math.cos(angle + side), to[1] + head * Math.sin(angle + side), to[2] ?? 0];
      this.add(to, tip, color, metres, pixels);
    }
  }

  done(): void {
    this.instances.done();
  }
}
