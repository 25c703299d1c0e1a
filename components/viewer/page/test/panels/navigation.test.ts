import assert from "node:assert/strict";
import test from "node:test";

import type { HandsContext } from "../../src/panels/hands/context";
import { cancel } from "../../src/panels/hands/drive_control";
import { statusText } from "../../src/panels/hands/navigation_status";
import { sendWaypoints } from "../../src/panels/hands/waypoints";
import { appOf, handsOf } from "./app";

const contextOf = (hands: ReturnType<typeof handsOf>, robot = "") => ({ app: appOf(hands, robot) }) as HandsContext;
const SEND = "/robot1/follow_waypoints/_action/send_goal";
const CANCEL = "/robot1/follow_waypoints/_action/cancel_goal";

test("waypoints go to the robot's action, with an id that cancels them", async () => {
  const hands = handsOf({ [SEND]: { accepted: true }, [CANCEL]: { return_code: 0 } });
  const context = contextOf(hands, "/robot1");
  const sent = await sendWaypoints(context, "follow_waypoints", [{ x: 1, y: 2, theta: 0 }, { x: 3, y: 4, theta: 0 }]);
  const [service, request] = hands.called[0]!;
  assert.equal(service, SEND);
  assert.equal(request.goal_id.uuid.length, 16);
  assert.deepEqual(request.goal.poses.map(({ pose }: any) => [pose.position.x, pose.position.y]), [[1, 2], [3, 4]]);

  await cancel(context, sent);
  assert.deepEqual(hands.called[1], [CANCEL, { goal_info: { goal_id: { uuid: sent.id }, stamp: { sec: 0, nanosec: 0 } } }]);
  assert.deepEqual(hands.published, []);
});

test("a goal that is not taken is told", async () => {
  const context = contextOf(handsOf({ [SEND]: { accepted: false } }), "/robot1");
  await assert.rejects(sendWaypoints(context, "follow_waypoints", [{ x: 1, y: 2, theta: 0 }]), /does not take the goal/);
});

test("a goal that is nobody's action, or whose action has ended, is canceled by the topic", async () => {
  // 3: ERROR_GOAL_TERMINATED of action_msgs/srv/CancelGoal
  const hands = handsOf({ [CANCEL]: { return_code: 3 } });
  await cancel(contextOf(hands, "/robot1"), { service: CANCEL, id: [] });
  await cancel(contextOf(hands), undefined);
  assert.deepEqual(hands.published, [
    ["/robot1/cancel_goal", "std_msgs/msg/Empty", {}],
    ["/cancel_goal", "std_msgs/msg/Empty", {}],
  ]);
});

test("the status is a sentence; the way to go is of interest until the end", () => {
  const status = { goal_id: 3n, status: 2, reason: "", distance_remaining: 4.26, number_of_recoveries: 0, number_of_goals_remaining: 2 };
  assert.equal(statusText(status), "Goal 3: driving, 4.3 m to go, 2 more to come");
  assert.equal(statusText({ ...status, status: 6, reason: "no path", number_of_goals_remaining: 0 }), "Goal 3: given up, no path");
});
