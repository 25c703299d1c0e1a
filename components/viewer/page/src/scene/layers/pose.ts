import { Discs, ellipseOf } from "../gl/discs";
import { Lines } from "../gl/lines";
import { TopicLayer, type Header, type Legend, type View } from "../layer";
import { withOpacity } from "../palette";
import { yawOf, type Quaternion } from "../../source/transforms";
import { DEVIATIONS } from "./people";

interface PoseWithCovarianceStamped {
  header: Header;
  pose: { pose: { position: { x: number; y: number }; orientation: Quaternion }; covariance: Float64Array };
}

const REACH = 0.9; // [m] of the lines that show how sure the heading is
const LEAST_HEADING = 0.01; // [rad] less is not seen

/** How sure the localization is of place and heading. */
export class PoseLayer extends TopicLayer<PoseWithCovarianceStamped> {
  readonly id = "pose";
  readonly name = "Pose covariance";
  readonly legend: Legend = { shape: "ring", colors: (palette) => [palette.robot], note: "86 %" };
  private readonly discs = new Discs(27);
  private readonly lines = new Lines(27);

  constructor() {
    super(["/amcl_pose", "geometry_msgs/msg/PoseWithCovarianceStamped"]);
    this.object.add(this.discs.mesh, this.lines.mesh);
  }

  protected draw({ pose: { pose, covariance } }: PoseWithCovarianceStamped, { palette }: View): void {
    this.discs.clear();
    this.lines.clear();
    const { x, y } = pose.position;
    const ellipse = ellipseOf(covariance[0]!, covariance[1]!, covariance[7]!, DEVIATIONS);
    if (ellipse) this.discs.add({ x, y, ...ellipse }, withOpacity(palette.robot, 0.14), withOpacity(palette.robot, 0.9), 1.2);
    const spread = DEVIATIONS * Math.sqrt(Math.max(covariance[35]!, 0));
    if (spread > LEAST_HEADING)
      for (const side of [-spread, spread]) {
        const angle = yawOf(pose.orientation) + Math.min(Math.max(side, -Math.PI), Math.PI);
        this.lines.add([x, y], [x + REACH * Math.cos(angle), y + REACH * Math.sin(angle)], withOpacity(palette.robot, 0.5), 0, 1.2);
      }
    this.discs.done();
    this.lines.done();
  }
}
