import { Discs, ellipseOf } from "../gl/discs";
import { Labels } from "../gl/labels";
import { Lines } from "../gl/lines";
import { Triangles } from "../gl/triangles";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { mix, withOpacity, type Palette } from "../palette";
import { compose } from "../../source/transforms";
import { isConfirmed } from "../confirmed";
import { addBody } from "./body";

export const TRACKS = "bandwagon_msgs/msg/Tracks";

export interface Track {
  id: number;
  position: { x: number; y: number };
  velocity: { x: number; y: number };
  covariance: Float64Array;
  radius: number;
  confidence?: number; // recordings from before it was told: people
  predictions: {
    time_from_start: { sec: number; nanosec: number };
    x: number;
    y: number;
    cov_xx: number;
    cov_xy: number;
    cov_yy: number;
  }[];
}

export interface Tracks {
  header: Header;
  tracks: Track[];
}

export const LARGEST = 3; // [m] half axis of an ellipse; one that is less sure says nothing
export const DEVIATIONS = 2; // an ellipse holds 86 %
const HEIGHT = 1.1; // [m] so that one sees over them
const FIRST_ROBOT = 2e9; // ids from here on are those of other robots (components/other_robots)
const STANDS = 0.1; // [m/s] slower needs no arrow
const PALE = 0.35; // of who is not confirmed

/** Everybody with number, velocity (where they are in a second) and how sure the place is. */
export class PeopleLayer extends TopicLayer<Tracks> {
  readonly id = "people";
  readonly name = "People";
  readonly legend: Legend = { shape: "disc", colors: (palette) => [palette.people], note: "ring: 86 %; pale: unsure" };
  private readonly bodies = new Triangles(50, { hasDepth: true, areBodies: true });
  private readonly discs = new Discs(51);
  private readonly lines = new Lines(52);
  private readonly labels = new Labels(92);
  private shown: Track[] = [];

  constructor() {
    super(["/tracks", TRACKS]);
    for (const part of this.parts) this.object.add(part.mesh);
  }

  protected draw({ tracks }: Tracks, { palette }: View): void {
    for (const part of this.parts) part.clear();
    this.shown = tracks;
    for (const track of tracks) this.drawTrack(track, palette);
    for (const part of this.parts) part.done();
  }

  /** Of those that are drawn, in the root frame. */
  positions(): { id: number; x: number; y: number }[] {
    const { position, rotation } = this.object;
    const frame = { x: position.x, y: position.y, theta: rotation.z };
    return this.shown.filter((track) => !isRobot(track) && isConfirmed(track)).map(({ id, position: at }) => {
      const { x, y } = compose(frame, { x: at.x, y: at.y, theta: 0 });
      return { id, x, y };
    });
  }

  private get parts() {
    return [this.bodies, this.discs, this.lines, this.labels];
  }

  private drawTrack(track: Track, palette: Palette): void {
    const { id, position, velocity, covariance, radius } = track;
    const { x, y } = position;
    if (!Number.isFinite(x + y)) return;
    const ring = ellipseOf(covariance[0]!, covariance[1]!, covariance[5]!, DEVIATIONS);
    const sure = isConfirmed(track);
    const rim = withOpacity(palette.people, sure ? 0.7 : 0.7 * PALE);
    if (ring && ring.a <= LARGEST) this.discs.add({ x, y, ...ring }, withOpacity(palette.people, 0), rim, 1.2);
    if (isRobot({ id })) return; // is drawn where it says that it is
    if (!sure) {
      this.discs.add({ x, y, a: radius, b: radius }, withOpacity(palette.people, PALE), undefined, 0);
      this.labels.add([x, y, 0], `${id}?`, palette.text, palette.halo, -20);
      return;
    }
    addBody(this.bodies, { x, y, radius, height: HEIGHT }, palette.people, mix(palette.people, [0, 0, 0, 1], 0.28));
    const speed = Math.hypot(velocity.x, velocity.y);
    if (speed > STANDS) this.lines.arrow([x, y], [x + velocity.x, y + velocity.y], palette.people, 0, 2, 0.18);
    this.labels.add([x, y, 0], `${id}`, palette.text, palette.halo, -20);
  }
}

export function isRobot({ id }: { id: number }): boolean {
  return id >= FIRST_ROBOT;
}
