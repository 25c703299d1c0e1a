// Where the robot is: tells the localization, as rviz2's "2D Pose Estimate".
import type { Pose2 } from "../../app";
import { groundFrame, type HandsContext } from "./context";
import { DragToolButton } from "./drag_tool";
import { text } from "./goal";
import { initialPose, poseOfDrag } from "./poses";

export function sendInitialPose(context: HandsContext, pose: Pose2): Promise<boolean> {
  const { app } = context;
  return context.run(`Initial pose ${text(pose)}`, () =>
    app.hands.publish(
      `${context.app.robot}/initialpose`,
      "geometry_msgs/msg/PoseWithCovarianceStamped",
      initialPose(groundFrame(app), pose, app.timeline.end),
    ),
  );
}

export function initialPoseTool(context: HandsContext, changed: () => void): DragToolButton {
  return new DragToolButton(
    context.app,
    {
      label: "Initial pose",
      hint: "Press where the robot is and drag the way it looks",
      test: "initial-pose",
      onRelease: (from, to) => void sendInitialPose(context, poseOfDrag(from, to)),
    },
    changed,
  );
}
