// An occupancy grid as a texture on the ground.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  Mesh,
  NearestFilter,
  NearestMipmapNearestFilter,
  RedFormat,
  ShaderMaterial,
  UnsignedByteType,
} from "three";
import { layerMesh } from "./layer_mesh";
import type { Rgba } from "../palette";

const VERTEX = `
attribute vec2 cell;
varying vec2 vCell;
void main() {
  vCell = cell;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Cells are -1 (unknown, 255 as a byte) or 0 to 100.
const FRAGMENT = `
uniform sampler2D cells;
uniform vec4 low;
uniform vec4 high;
varying vec2 vCell;
void main() {
  float value = texture2D(cells, vCell).r * 255.0;
  if (value > 100.5) discard;
  gl_FragColor = mix(low, high, value / 100.0);
  if (gl_FragColor.a < 0.004) discard;
}`;

export interface OccupancyGrid {
  header: { stamp: { sec: number; nanosec: number }; frame_id: string };
  info: {
    resolution: number;
    width: number;
    height: number;
    origin: { position: { x: number; y: number }; orientation: { x: number; y: number; z: number; w: number } };
  };
  data: Int8Array;
}

export class Grid {
  readonly mesh: Mesh<BufferGeometry, ShaderMaterial>;
  private texture: DataTexture | undefined;

  constructor(order: number) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0]), 3));
    geometry.setAttribute("cell", new BufferAttribute(new Float32Array([0, 0, 1, 0, 1, 1, 0, 1]), 2));
    geometry.setIndex([0, 1, 2, 0, 2, 3]);
    const material = new ShaderMaterial({
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: { cells: { value: null }, low: { value: [0, 0, 0, 0] }, high: { value: [1, 1, 1, 1] } },
      transparent: true,
      depthTest: false,
      depthWrite: false,
    });
    this.mesh = layerMesh(geometry, material, order);
  }

  /** `low`: of value 0, `high`: of 100. */
  set(grid: OccupancyGrid | undefined, low: Rgba, high: Rgba): void {
    const isWhole = grid !== undefined && grid.data.length > 0 && grid.data.length === grid.info.width * grid.info.height;
    this.mesh.visible = isWhole;
    if (!isWhole) return;
    const { width, height, resolution } = grid.info;
    const cells = new Uint8Array(grid.data.buffer, grid.data.byteOffset, grid.data.length);
    if (this.texture?.image.width !== width || this.texture.image.height !== height) this.texture = this.make(cells, width, height);
    this.texture.image.data = cells;
    this.texture.mipmaps = smaller(cells, width, height);
    this.texture.needsUpdate = true;
    const { uniforms } = this.mesh.material;
    uniforms.cells!.value = this.texture;
    uniforms.low!.value = low;
    uniforms.high!.value = high;
    this.mesh.scale.set(width * resolution, height * resolution, 1);
  }

  private make(cells: Uint8Array, width: number, height: number): DataTexture {
    this.texture?.dispose();
    const texture = new DataTexture(cells as Uint8Array<ArrayBuffer>, width, height, RedFormat, UnsignedByteType);
    texture.unpackAlignment = 1;
    texture.magFilter = NearestFilter;
    texture.minFilter = NearestMipmapNearestFilter;
    return texture;
  }
}

const UNKNOWN = 255;

interface Level {
  data: Uint8Array<ArrayBuffer>;
  width: number;
  height: number;
}

/**
 * The grid and each half of it, as seen from farther and farther away. Of four cells the one of the highest cost counts: a wall stays a wall where it
 * is thinner than a pixel.
 */
export function smaller(cells: Uint8Array, width: number, height: number): Level[] {
  const levels: Level[] = [{ data: cells as Uint8Array<ArrayBuffer>, width, height }];
  for (let level = levels[0]!; level.width > 1 || level.height > 1; ) {
    level = halved(level);
    levels.push(level);
  }
  return levels;
}

function halved({ data, width, height }: Level): Level {
  const half = { width: Math.max(width >> 1, 1), height: Math.max(height >> 1, 1) };
  const result = new Uint8Array(half.width * half.height).fill(UNKNOWN);
  for (let y = 0; y < height; ++y) {
    const row = Math.min(y >> 1, half.height - 1) * half.width;
    for (let x = 0; x < width; ++x) {
      const value = data[y * width + x]!;
      const at = row + Math.min(x >> 1, half.width - 1);
      if (value !== UNKNOWN && (result[at] === UNKNOWN || value > result[at]!)) result[at] = value;
    }
  }
  return { data: result, ...half };
}
