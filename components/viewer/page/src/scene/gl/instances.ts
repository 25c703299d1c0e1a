// Many copies of one small quad, each with numbers of its own; drawn in one call. Each copy has four corners of its own in the buffer: drawn as
// instances they would need a quarter of it, but software rendering sets up a draw for every instance.
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, InterleavedBuffer, InterleavedBufferAttribute, Mesh, ShaderMaterial, type IUniform } from "three";
import { layerMesh } from "./layer_mesh";

/** `position` of the corners: x from 0 to 1, y from -1 to 1. */
const CORNERS = [
  [0, -1],
  [1, -1],
  [1, 1],
  [0, 1],
];
const QUAD = [0, 1, 2, 0, 2, 3];

/** What all shaders share; the scene sets it once per frame. */
export const SHARED: Record<string, IUniform> = {
  viewport: { value: [1, 1] }, // [px] of the device
  pixelRatio: { value: 1 },
  upright: { value: 0 }, // how much of its height a body shows: 0 from above, 1 tilted
};

export interface Shader {
  vertex: string;
  fragment: string;
  uniforms?: Record<string, IUniform>;
}

export class Instances {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  count = 0;
  private values: Float32Array;
  private readonly stride: number;
  private buffer!: InterleavedBuffer;

  /** `layout`: names and sizes of the attributes, in the order in which `add` gets them. */
  constructor(private readonly layout: Record<string, number>, shader: Shader, order: number, private capacity = 64) {
    this.stride = 2 + Object.values(layout).reduce((sum, size) => sum + size, 0);
    this.values = new Float32Array(capacity * 4 * this.stride);
    const material = new ShaderMaterial({
      vertexShader: shader.vertex,
      fragmentShader: shader.fragment,
      uniforms: { ...SHARED, ...shader.uniforms },
      transparent: true,
      depthTest: false,
      depthWrite: false,
    });
    this.mesh = layerMesh(this.geometry(), material, order);
  }

  clear(): void {
    this.count = 0;
  }

  add(...values: number[]): void {
    if (this.count === this.capacity) this.grow();
    let at = this.count * 4 * this.stride;
    for (const corner of CORNERS) {
      this.values.set(corner, at);
      this.values.set(values, at + 2);
      at += this.stride;
    }
    ++this.count;
  }

  /** After the last `add`. */
  done(): void {
    this.mesh.geometry.setDrawRange(0, this.count * QUAD.length);
    this.mesh.visible = this.count > 0;
    this.buffer.clearUpdateRanges();
    this.buffer.addUpdateRange(0, this.count * 4 * this.stride);
    this.buffer.needsUpdate = true;
  }

  private grow(): void {
    this.capacity *= 2;
    const bigger = new Float32Array(this.values.length * 2);
    bigger.set(this.values);
    this.values = bigger;
    this.mesh.geometry.dispose();
    this.mesh.geometry = this.geometry();
  }

  private geometry(): BufferGeometry {
    const geometry = new BufferGeometry();
    this.buffer = new InterleavedBuffer(this.values, this.stride).setUsage(DynamicDrawUsage);
    let offset = 0;
    for (const [name, size] of Object.entries({ position: 2, ...this.layout })) {
      geometry.setAttribute(name, new InterleavedBufferAttribute(this.buffer, size, offset));
      offset += size;
    }
    const index = new Uint32Array(this.capacity * QUAD.length).map((_, i) => Math.floor(i / QUAD.length) * 4 + QUAD[i % QUAD.length]!);
    geometry.setIndex(new BufferAttribute(index, 1));
    return geometry;
  }
}
