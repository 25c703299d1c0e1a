// Discs and ellipses on the ground, filled and with an edge of so many pixels.
import type { Rgba } from "../palette";
import { Instances } from "./instances";

const VERTEX = `
attribute vec4 place;   // x, y, z, angle
attribute vec4 size;    // half axes [m], width of the edge [px], at least so large [px]
attribute vec4 fill;
attribute vec4 edge;
uniform vec2 viewport;
uniform float pixelRatio;
varying vec2 vAt;
varying vec2 vHalf;
varying float vEdge;
varying vec4 vFill;
varying vec4 vRim;

void main() {
  vec4 middle = projectionMatrix * modelViewMatrix * vec4(place.xyz, 1.0);
  float metre = projectionMatrix[1][1] * viewport.y * 0.5 / max(middle.w, 0.05);
  vHalf = max(size.xy, size.w * pixelRatio / metre * 0.5);
  vEdge = size.z * pixelRatio;
  vAt = vec2(position.x * 2.0 - 1.0, position.y) * (vHalf + 2.0 / metre);
  float c = cos(place.w);
  float s = sin(place.w);
  vec3 at = place.xyz + vec3(c * vAt.x - s * vAt.y, s * vAt.x + c * vAt.y, 0.0);
  vFill = fill;
  vRim = edge;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(at, 1.0);
}`;

const FRAGMENT = `
varying vec2 vAt;
varying vec2 vHalf;
varying float vEdge;
varying vec4 vFill;
varying vec4 vRim;
void main() {
  float r = length(vAt / vHalf);
  float outside = (r - 1.0) / max(fwidth(r), 1e-6); // [px] of the boundary
  float cover = clamp(0.5 - outside, 0.0, 1.0);
  if (cover <= 0.0) discard;
  float rim = vEdge > 0.0 ? clamp(outside + vEdge + 0.5, 0.0, 1.0) : 0.0;
  float alpha = mix(vFill.a, vRim.a, rim);
  vec3 color = mix(vFill.rgb, vRim.rgb, vFill.a < 0.01 ? 1.0 : rim);
  gl_FragColor = vec4(color, alpha * cover);
}`;

export interface Ellipse {
  x: number;
  y: number;
  z?: number;
  angle?: number;
  /** Half axes [m]. */
  a: number;
  b: number;
}

const NONE: Rgba = [0, 0, 0, 0];

export class Discs {
  private readonly instances: Instances;

  constructor(order: number) {
    this.instances = new Instances({ place: 4, size: 4, fill: 4, edge: 4 }, { vertex: VERTEX, fragment: FRAGMENT }, order);
  }

  get mesh() {
    return this.instances.mesh;
  }

  get count(): number {
    return this.instances.count;
  }

  clear(): void {
    this.instances.clear();
  }

  /** `least` [px]: small ones are drawn this large. */
  add({ x, y, z, angle, a, b }: Ellipse, fill: Rgba, edge: Rgba = NONE, edgeWidth = 0, least = 0): void {
    this.instances.add(x, y, z ?? 0, angle ?? 0, a, b, edgeWidth, least, ...fill, ...edge);
  }

  done(): void {
    this.instances.done();
  }
}

/** The ellipse of so many standard deviations; undefined for what is no covariance. */
export function ellipseOf(xx: number, xy: number, yy: number, deviations: number): { a: number; b: number; angle: number } | undefined {
  const middle = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  if (!Number.isFinite(middle + spread) || middle <= 0) return undefined;
  const half = (variance: number) => deviations * Math.sqrt(Math.max(variance, 0));
  return { a: half(middle + spread), b: half(middle - spread), angle: Math.atan2(2 * xy, xx - yy) / 2 };
}
