// Many copies of one small shape, each with numbers of its own; drawn in one call.
import {
  InstancedBufferGeometry,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  BufferAttribute,
  Mesh,
  ShaderMaterial,
  type IUniform,
} from "three";

/** x from 0 to 1, y from -1 to 1. */
const CORNERS = new Float32Array([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0]);
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
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  count = 0;
  private values: Float32Array;
  private readonly stride: number;
  private buffer: InstancedInterleavedBuffer;

  /** `layout`: names and sizes of the attributes, in the order in which `add` gets them. */
  constructor(private readonly layout: Record<string, number>, shader: Shader, order: number, capacity = 64) {
    this.stride = Object.values(layout).reduce((sum, size) => sum + size, 0);
    this.values = new Float32Array(capacity * this.stride);
    this.buffer = new InstancedInterleavedBuffer(this.values, this.stride);
    const material = new ShaderMaterial({
      vertexShader: shader.vertex,
      fragmentShader: shader.fragment,
      uniforms: { ...SHARED, ...shader.uniforms },
      transparent: true,
      depthTest: false,
      depthWrite: false,
    });
    this.mesh = new Mesh(this.geometry(), material);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = order;
    this.mesh.visible = false;
  }

  clear(): void {
    this.count = 0;
  }

  add(...values: number[]): void {
    const at = this.count * this.stride;
    if (at + this.stride > this.values.length) this.grow();
    this.values.set(values, at);
    ++this.count;
  }

  /** After the last `add`. */
  done(): void {
    this.mesh.geometry.instanceCount = this.count;
    this.mesh.visible = this.count > 0;
    this.buffer.clearUpdateRanges();
    this.buffer.addUpdateRange(0, this.count * this.stride);
    this.buffer.needsUpdate = true;
  }

  private grow(): void {
    const bigger = new Float32Array(this.values.length * 2);
    bigger.set(this.values);
    this.values = bigger;
    this.buffer = new InstancedInterleavedBuffer(bigger, this.stride);
    this.mesh.geometry.dispose();
    this.mesh.geometry = this.geometry();
  }

  private geometry(): InstancedBufferGeometry {
    const geometry = new InstancedBufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(CORNERS, 3));
    geometry.setIndex(QUAD);
    let offset = 0;
    for (const [name, size] of Object.entries(this.layout)) {
      geometry.setAttribute(name, new InterleavedBufferAttribute(this.buffer, size, offset));
      offset += size;
    }
    geometry.instanceCount = 0;
    return geometry;
  }
}
