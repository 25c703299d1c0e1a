// Text over the scene: always upright and of one size, with a halo of the ground's colour. Letters come from one texture.
import { CanvasTexture, LinearFilter } from "three";
import type { Rgba } from "../palette";
import { Instances } from "./instances";
import type { Point } from "./lines";

const FIRST = 32;
const LAST = 126;
const COLUMNS = 16;
const FONT = "600 12px system-ui, -apple-system, 'Segoe UI', 'Noto Sans', 'DejaVu Sans', sans-serif";
const CELL = { width: 18, height: 20 }; // [px] of one letter and its halo
const HALO = 3; // [px]

const VERTEX = `
attribute vec3 anchor;
attribute vec3 place; // offset [px] of the letter's left edge, upward; number of the letter
attribute vec4 color;
attribute vec3 halo;
uniform vec2 viewport;
uniform float pixelRatio;
uniform vec2 cell;
uniform vec2 cells;
varying vec2 vUv;
varying vec4 vColor;
varying vec3 vHalo;
void main() {
  vec4 at = projectionMatrix * modelViewMatrix * vec4(anchor, 1.0);
  if (at.w < 0.05) { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); return; }
  vec2 corner = vec2(position.x, position.y * 0.5 + 0.5);
  vec2 pixel = floor((at.xy / at.w * 0.5 + 0.5) * viewport) + floor(place.xy * pixelRatio + 0.5) + corner * cell * pixelRatio;
  float row = floor(place.z / cells.x);
  vUv = (vec2(place.z - row * cells.x, cells.y - 1.0 - row) + corner) / cells;
  vColor = color;
  vHalo = halo;
  gl_Position = vec4(pixel / viewport * 2.0 - 1.0, 0.0, 1.0);
}`;

// Of the texture: red is the letter, opacity the letter with its halo.
const FRAGMENT = `
uniform sampler2D letters;
varying vec2 vUv;
varying vec4 vColor;
varying vec3 vHalo;
void main() {
  vec4 texel = texture2D(letters, vUv);
  if (texel.a < 0.02) discard;
  gl_FragColor = vec4(mix(vHalo, vColor.rgb, texel.r / texel.a), texel.a * vColor.a);
}`;

interface Letters {
  texture: CanvasTexture;
  widths: number[];
}

let letters: Letters | undefined;

function drawLetters(pixelRatio: number): Letters {
  const rows = Math.ceil((LAST - FIRST + 1) / COLUMNS);
  const canvas = document.createElement("canvas");
  canvas.width = COLUMNS * CELL.width * pixelRatio;
  canvas.height = rows * CELL.height * pixelRatio;
  const context = canvas.getContext("2d")!;
  context.scale(pixelRatio, pixelRatio);
  context.font = FONT;
  context.textBaseline = "alphabetic";
  context.lineJoin = "round";
  context.lineWidth = HALO;
  const widths: number[] = [];
  for (let code = FIRST; code <= LAST; ++code) {
    const letter = String.fromCharCode(code);
    const x = ((code - FIRST) % COLUMNS) * CELL.width + HALO;
    const y = Math.floor((code - FIRST) / COLUMNS) * CELL.height + CELL.height - 6;
    context.strokeStyle = "#000";
    context.strokeText(letter, x, y);
    context.fillStyle = "#f00";
    context.fillText(letter, x, y);
    widths.push(context.measureText(letter).width);
  }
  const texture = new CanvasTexture(canvas);
  texture.minFilter = texture.magFilter = LinearFilter;
  texture.generateMipmaps = false;
  texture.premultiplyAlpha = true;
  return { texture, widths };
}

export class Labels {
  private readonly instances: Instances;

  constructor(order: number) {
    letters ??= drawLetters(Math.ceil(window.devicePixelRatio));
    const uniforms = {
      letters: { value: letters.texture },
      cell: { value: [CELL.width, CELL.height] },
      cells: { value: [COLUMNS, Math.ceil((LAST - FIRST + 1) / COLUMNS)] },
    };
    const shader = { vertex: VERTEX, fragment: FRAGMENT, uniforms };
    this.instances = new Instances({ anchor: 3, place: 3, color: 4, halo: 3 }, shader, order, 128);
  }

  get mesh() {
    return this.instances.mesh;
  }

  clear(): void {
    this.instances.clear();
  }

  /** Centred at a point, raised by so many pixels. */
  add(at: Point, text: string, color: Rgba, halo: Rgba, raised = 0): void {
    const codes = [...text].map((letter) => {
      const code = letter.charCodeAt(0);
      return code >= FIRST && code <= LAST ? code - FIRST : "?".charCodeAt(0) - FIRST;
    });
    const { widths } = letters!;
    let x = -codes.reduce((sum, code) => sum + widths[code]!, 0) / 2 - HALO;
    for (const code of codes) {
      this.instances.add(at[0], at[1], at[2] ?? 0, x, raised - CELL.height / 2, code, ...color, halo[0], halo[1], halo[2]);
      x += widths[code]!;
    }
  }

  done(): void {
    this.instances.done();
  }
}
