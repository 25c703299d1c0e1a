import { isConfirmed } from "../confirmed";
import { Discs, ellipseOf } from "../gl/discs";
import { TopicLayer, type Legend, type View } from "../layer";
import { withOpacity } from "../palette";
import { DEVIATIONS, LARGEST, TRACKS, type Track, type Tracks } from "./people";

const STEP = 0.5; // [s]
const HORIZON = 3; // [s]
const CERTAIN = 0.5; // [m^2] product of the half axes up to which an ellipse is drawn in full; a larger one is paler, as the certainty thins out

interface Expected {
  time: number;
  x: number;
  y: number;
  ellipse: { a: number; b: number; angle: number } | undefined;
}

/** Where people will be each half second, and the ellipse of two standard deviations; paler the later. */
export class PredictionsLayer extends TopicLayer<Tracks> {
  readonly id = "predictions";
  readonly name = "Predictions";
  readonly legend: Legend = { shape: "ring", colors: (palette) => [palette.people], note: "each 0.5 s to 3 s, 86 %" };
  private readonly discs = new Discs(35);

  constructor() {
    super(["/tracks", TRACKS]);
    this.object.add(this.discs.mesh);
  }

  protected draw({ tracks }: Tracks, { palette, lift }: View): void {
    this.discs.clear();
    for (const track of tracks.filter(isConfirmed))
      for (const { time, x, y, ellipse } of expectedOf(track).reverse()) {
        const pale = 1 - time / (HORIZON + STEP);
        const z = lift * time;
        if (ellipse && ellipse.a <= LARGEST) {
          const thin = Math.min(1, CERTAIN / (ellipse.a * ellipse.b));
          const rim = withOpacity(palette.people, 0.08 + (0.1 + 0.4 * pale) * thin);
          this.discs.add({ x, y, z, ...ellipse }, withOpacity(palette.people, (0.03 + 0.12 * pale) * thin), rim, 1);
        }
        this.discs.add({ x, y, z, a: 0.04, b: 0.04 }, withOpacity(palette.people, 0.3 + 0.6 * pale), undefined, 0, 4);
      }
    this.discs.done();
  }
}

/** About one each step; who comes without predictions keeps the velocity. */
export function expectedOf(track: Track): Expected[] {
  const expected: Expected[] = [];
  for (const { time_from_start, x, y, cov_xx, cov_xy, cov_yy } of track.predictions) {
    const time = time_from_start.sec + time_from_start.nanosec / 1e9;
    if (time > HORIZON + 1e-6) break;
    if (time < STEP - 1e-6 || time < (expected.at(-1)?.time ?? 0) + STEP - 1e-6) continue;
    if (Number.isFinite(x + y)) expected.push({ time, x, y, ellipse: ellipseOf(cov_xx, cov_xy, cov_yy, DEVIATIONS) });
  }
  if (track.predictions.length > 0) return expected;
  const { position, velocity } = track;
  for (let time = STEP; time <= HORIZON; time += STEP)
    expected.push({ time, x: position.x + time * velocity.x, y: position.y + time * velocity.y, ellipse: undefined });
  return expected;
}
