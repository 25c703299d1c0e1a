// Plain triangles with a colour per corner.
import { BufferAttribute, BufferGeometry, DoubleSide, DynamicDrawUsage, Mesh, ShaderMaterial } from "three";
import { layerMesh } from "./layer_mesh";
import type { Rgba } from "../palette";
import type { Point } from "./lines";
import { SHARED } from "./instances";

const VERTEX = `
attribute vec4 color;
uniform float upright;
uniform float bodies;
varying vec4 vColor;
void main() {
  vColor = color;
  float z = position.z * mix(1.0, upright, bodies);
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position.xy, z, 1.0);
}`;

const FRAGMENT = `
varying vec4 vColor;
void main() { gl_FragColor = vColor; }`;

export class Triangles {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private positions = new Float32Array(3 * 192);
  private colors = new Float32Array(4 * 192);
  private count = 0;

  /** `hasDepth`: nearer ones hide farther ones. `areBodies`: what stands up is flat when it is seen from above. */
  constructor(order: number, { hasDepth = false, areBodies = false } = {}) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { upright: SHARED.upright!, bodies: { value: areBodies ? 1 : 0 } },
      transparent: true,
      depthTest: hasDepth,
      depthWrite: hasDepth,
      side: DoubleSide,
    });
    this.mesh = layerMesh(this.geometry(), material, order);
  }

  clear(): void {
    this.count = 0;
  }

  add(a: Point, b: Point, c: Point, colorA: Rgba, colorB = colorA, colorC = colorA): void {
    this.corner(a, colorA);
    this.corner(b, colorB);
    this.corner(c, colorC);
  }

  quad(a: Point, b: Point, c: Point, d: Point, color: Rgba, colorCD = color): void {
    this.add(a, b, c, color, color, colorCD);
    this.add(a, c, d, color, colorCD, colorCD);
  }

  done(): void {
    const { geometry } = this.mesh;
    geometry.setDrawRange(0, this.count);
    this.mesh.visible = this.count > 0;
    for (const name of ["position", "color"] as const) {
      const attribute = geometry.getAttribute(name) as BufferAttribute;
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, this.count * attribute.itemSize);
      attribute.needsUpdate = true;
    }
  }

  private corner(at: Point, color: Rgba): void {
    if (this.count * 3 + 3 > this.positions.length) this.grow();
    this.positions.set([at[0], at[1], at[2] ?? 0], this.count * 3);
    this.colors.set(color, this.count * 4);
    ++this.count;
  }

  private grow(): void {
    const bigger = (values: Float32Array<ArrayBuffer>) => {
      const copy = new Float32Array(values.length * 2);
      copy.set(values);
      return copy;
    };
    this.positions = bigger(this.positions);
    this.colors = bigger(this.colors);
    this.mesh.geometry.dispose();
    this.mesh.geometry = this.geometry();
  }

  private geometry(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(this.positions, 3).setUsage(DynamicDrawUsage));
    geometry.setAttribute("color", new BufferAttribute(this.colors, 4).setUsage(DynamicDrawUsage));
    return geometry;
  }
}
