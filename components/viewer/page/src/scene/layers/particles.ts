import { Lines } from "../gl/lines";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { withOpacity } from "../palette";
import { yawOf, type Quaternion } from "../../source/transforms";

interface PoseArray {
  header: Header;
  poses: { position: { x: number; y: number }; orientation: Quaternion }[];
}

const LENGTH = 0.16; // [m]
const MOST = 3000;

/** Where the particle filter thinks the robot may be; of very many every so many. */
export class ParticlesLayer extends TopicLayer<PoseArray> {
  readonly id = "particles";
  readonly name = "Particles";
  readonly legend: Legend = { shape: "points", colors: (palette) => [palette.particles] };
  private readonly lines = new Lines(28);

  constructor() {
    super(["/particle_poses", "geometry_msgs/msg/PoseArray"]);
    this.object.add(this.lines.mesh);
  }

  protected draw({ poses }: PoseArray, { palette }: View): void {
    this.lines.clear();
    const color = withOpacity(palette.particles, 0.55);
    const every = Math.max(1, Math.ceil(poses.length / MOST));
    for (let i = 0; i < poses.length; i += every) {
      const { position, orientation } = poses[i]!;
      const yaw = yawOf(orientation);
      this.lines.add([position.x, position.y], [position.x + LENGTH * Math.cos(yaw), position.y + LENGTH * Math.sin(yaw)], color, 0, 1.5);
    }
    this.lines.done();
  }
}
