// A goal: where the press was, looking along the drag.
import type { Pose2 } from "../../app";
import { groundFrame, robotPose, type HandsContext } from "./context";
import { DragToolButton } from "./drag_tool";
import { poseOfDrag, poseStamped } from "./poses";

export function sendGoal(context: HandsContext, pose: Pose2): Promise<boolean> {
  const frame = groundFrame(context.app);
  return context.run(`Goal ${text(pose)}`, async () => {
    // Before the tree of frames is whole, its root may be any frame of the robot.
    if (robotPose(context) === undefined) throw new Error(`where the robot is in ${frame} is not known yet`);
    await context.app.hands.publish(`${context.app.robot}/goal_pose`, "geometry_msgs/msg/PoseStamped", poseStamped(frame, pose));
  });
}

export function goalTool(context: HandsContext, changed: () => void): DragToolButton {
  return new DragToolButton(
    context.app,
    {
      label: "Goal",
      hint: "Press where the robot is to go and drag the way it is to look",
      test: "goal",
      onRelease: (from, to) => void sendGoal(context, poseOfDrag(from, to, robotPose(context))),
    },
    changed,
  );
}

export function text(pose: Pose2): string {
  return `(${pose.x.toFixed(2)}, ${pose.y.toFixed(2)}, ${Math.round((pose.theta * 180) / Math.PI)}°)`;
}
