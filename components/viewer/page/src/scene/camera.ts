// Where the scene is seen from: a point of the ground, a distance, a direction and a tilt.
import { PerspectiveCamera, Vector3 } from "three";

export const FIELD_OF_VIEW = 20; // [deg] narrow: from above nearly without perspective
const NEAREST = 2; // [m]
const FARTHEST = 2000; // [m]
const MOST_TILT = 1.25; // [rad]
export const TILTED = 0.9; // [rad]
const TURN_TIME = 0.25; // [s] from one view to the other

export class Viewpoint {
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.1, 5000);
  target = { x: 0, y: 0 };
  distance = 30;
  /** Turned about the vertical [rad]; 0: x to the right, y up. */
  azimuth = 0;
  tilt = 0;
  private wantedTilt = 0;
  private size = { width: 1, height: 1 };

  setSize(width: number, height: number): void {
    this.size = { width, height };
    this.camera.aspect = width / Math.max(height, 1);
    this.camera.updateProjectionMatrix();
  }

  get wantsTilt(): number {
    return this.wantedTilt;
  }

  lookFrom(tilt: number): void {
    this.wantedTilt = tilt;
    if (tilt === 0) this.azimuth = 0;
  }

  /** Towards the tilt that is wanted; true while it is not there yet. */
  turn(elapsed: number): boolean {
    const rest = this.wantedTilt - this.tilt;
    const step = (TILTED / TURN_TIME) * elapsed;
    this.tilt += Math.min(Math.max(rest, -step), step);
    return this.tilt !== this.wantedTilt;
  }

  /** Call after changes, before drawing. */
  update(): void {
    const { x, y } = this.target;
    const away = this.distance * Math.sin(this.tilt);
    const up = this.distance * Math.cos(this.tilt);
    this.camera.up.set(-Math.sin(this.azimuth), Math.cos(this.azimuth), 0);
    if (this.tilt > 0.01) this.camera.up.set(0, 0, 1);
    this.camera.position.set(x + away * Math.sin(this.azimuth), y - away * Math.cos(this.azimuth), up);
    this.camera.near = this.distance * 0.02;
    this.camera.far = this.distance * 20;
    this.camera.lookAt(x, y, 0);
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
  }

  /** A rectangle of the ground fills the view, but for `margin` [px] on the left. */
  fit(x0: number, y0: number, x1: number, y1: number, margin: number): void {
    const { width, height } = this.size;
    const free = Math.max(width - margin, width / 2);
    const perHeight = 2 * Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
    const high = Math.max(y1 - y0, ((x1 - x0) * height) / free) * 1.06;
    this.distance = Math.min(Math.max(high / perHeight, NEAREST), FARTHEST);
    const metresPerPixel = high / height;
    this.target = { x: (x0 + x1) / 2 - ((width - free) / 2) * metresPerPixel, y: (y0 + y1) / 2 };
  }

  /** The point of the ground at a place of the screen [px]; undefined above the horizon. */
  ground(px: number, py: number): { x: number; y: number } | undefined {
    const { width, height } = this.size;
    const through = new Vector3((px / width) * 2 - 1, 1 - (py / height) * 2, 0.5).unproject(this.camera);
    const { position } = this.camera;
    const ray = through.sub(position);
    if (ray.z > -1e-6) return undefined;
    const reach = -position.z / ray.z;
    return { x: position.x + reach * ray.x, y: position.y + reach * ray.y };
  }

  toScreen(x: number, y: number, z = 0): { x: number; y: number } {
    const at = new Vector3(x, y, z).project(this.camera);
    return { x: ((at.x + 1) / 2) * this.size.width, y: ((1 - at.y) / 2) * this.size.height };
  }

  /** The ground that was at one place of the screen comes to another. */
  drag(from: { x: number; y: number }, to: { x: number; y: number }): void {
    const a = this.ground(from.x, from.y);
    const b = this.ground(to.x, to.y);
    if (!a || !b) return;
    const far = this.distance * 2; // near the horizon a pixel is a mile
    this.target.x += Math.min(Math.max(a.x - b.x, -far), far);
    this.target.y += Math.min(Math.max(a.y - b.y, -far), far);
    this.update();
  }

  zoom(factor: number, at: { x: number; y: number }): void {
    const before = this.ground(at.x, at.y);
    this.distance = Math.min(Math.max(this.distance * factor, NEAREST), FARTHEST);
    this.update();
    const after = this.ground(at.x, at.y);
    if (!before || !after) return;
    this.target.x += before.x - after.x;
    this.target.y += before.y - after.y;
    this.update();
  }

  orbit(turn: number, tilt: number): void {
    this.azimuth += turn;
    this.tilt = this.wantedTilt = Math.min(Math.max(this.tilt + tilt, 0), MOST_TILT);
    this.update();
  }
}
