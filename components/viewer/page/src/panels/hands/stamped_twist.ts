// A command by hand says how old it is, by the robot's own clock: its stamp is the time that the page heard last from the robot. So its age, when
// it comes, is that of the way there and back, constant delays included, whatever the clock of this computer says and however often it is set.
import type { Seconds } from "../../app";
import type { Twist } from "./driver";
import { stampOf } from "./poses";

export const STAMPED_TWIST = "geometry_msgs/msg/TwistStamped";

/** `heard`: the newest time of the robot. Without one the age could not be told, and the command would be obeyed however late it is. */
export function stampedTwist(twist: Twist, heard: Seconds): object {
  if (!(heard > 0)) throw new Error("the robot's time is not known yet");
  return { header: { stamp: stampOf(heard), frame_id: "" }, twist };
}
