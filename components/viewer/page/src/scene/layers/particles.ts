import { Lines } from "../gl/lines";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { withOpacity } from "../palette";
import { yawOf, type Quaternion } from "../../source/transforms";

interface ParticleCloud {
  header: Header;
  particles: { pose: { position: { x: number; y: number }; orientation: Quaternion } }[];
}

const LENGTH = 0.16; // [m]
const MOST = 3000;

/** Where the particle filter thinks the robot may be; of very many every so many. */
export class ParticlesLayer extends TopicLayer<ParticleCloud> {
  readonly id = "particles";
  readonly name = "Particles";
  readonly legend: Legend = { shape: "points", colors: (palette) => [palette.particles] };
  private readonly lines = new Lines(28);

  constructor() {
    super(["/particle_cloud", "nav2_msgs/msg/ParticleCloud"]);
    this.object.add(this.lines.mesh);
  }

  protected draw({ particles }: ParticleCloud, { palette }: View): void {
    this.lines.clear();
    const color = withOpacity(palette.particles, 0.55);
    const every = Math.max(1, Math.ceil(particles.length / MOST));
    for (let i = 0; i < particles.length; i += every) {
      const { position, orientation } = particles[i]!.pose;
      const yaw = yawOf(orientation);
      this.lines.add([position.x, position.y], [position.x + LENGTH * Math.cos(yaw), position.y + LENGTH * Math.sin(yaw)], color, 0, 1.5);
    }
    this.lines.done();
  }
}
