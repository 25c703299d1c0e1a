// What is known of the robot's stop, in words: from base_state, manual_override and navigation_status alone,
// never from what this page has sent.

/** bandwagon_msgs/msg/BaseState, as far as it is looked at. */
export interface BaseState {
  state: number;
  is_latched: boolean;
  reason: string;
}

/** bandwagon_msgs/msg/NavigationStatus, as far as it is looked at. */
export interface GoalStatus {
  goal_id: number | bigint;
  status: number;
  reason: string;
}

const EMERGENCY_STOP = 3; // and whatever is above stands
const EXECUTING = 2; // action_msgs/msg/GoalStatus: until then the goal is in hand

export interface StopState {
  /** Empty: nothing keeps it from driving. */
  text: string;
  /** The emergency stop is in force: latched at the base. */
  isInForce: boolean;
  /** A release lets it go on. */
  canRelease: boolean;
}

/** What becomes of the newest goal while the base stands: one in hand waits, one that came meanwhile ended with the base's reason. */
function goalText(goal: GoalStatus | undefined, canRelease: boolean): string {
  if (goal === undefined) return "";
  if (goal.status <= EXECUTING) return `. Goal ${goal.goal_id} waits${canRelease ? " for the release" : ""}`;
  return goal.reason.startsWith("the base stands") ? `. Goal ${goal.goal_id} was not taken` : "";
}

/** Of the newest messages; `base` undefined: none, or none for a second. `isOverridden`: a hand has interrupted who was driving. */
export function stopState(base: BaseState | undefined, isOverridden: boolean, goal?: GoalStatus): StopState {
  if (base === undefined) return { text: "base_state is not heard", isInForce: false, canRelease: false };
  const isInForce = base.state === EMERGENCY_STOP && base.is_latched;
  if (base.state >= EMERGENCY_STOP || base.is_latched)
    return {
      text: `Stopped: ${base.reason || "the base does not say why"}${goalText(goal, base.is_latched)}`,
      isInForce,
      canRelease: base.is_latched,
    };
  if (isOverridden) return { text: "Interrupted by a hand: waits for a release", isInForce, canRelease: true };
  return { text: "", isInForce, canRelease: false };
}
