// What is known of the robot's stop, in words: from base_state and manual_override alone, never from what this page has sent.

/** bandwagon_msgs/msg/BaseState, as far as it is looked at. */
export interface BaseState {
  state: number;
  is_latched: boolean;
  reason: string;
}

const EMERGENCY_STOP = 3; // and whatever is above stands

export interface StopState {
  /** Empty: nothing keeps it from driving. */
  text: string;
  /** The emergency stop is in force: latched at the base. */
  isInForce: boolean;
  /** A release lets it go on. */
  canRelease: boolean;
}

/** Of the newest messages; `base` undefined: none, or none for a second. `isOverridden`: a hand has interrupted who was driving. */
export function stopState(base: BaseState | undefined, isOverridden: boolean): StopState {
  if (base === undefined) return { text: "base_state is not heard", isInForce: false, canRelease: false };
  const isInForce = base.state === EMERGENCY_STOP && base.is_latched;
  if (base.state >= EMERGENCY_STOP || base.is_latched)
    return { text: `Stopped: ${base.reason || "the base does not say why"}`, isInForce, canRelease: base.is_latched };
  if (isOverridden) return { text: "Interrupted by a hand: waits for a release", isInForce, canRelease: true };
  return { text: "", isInForce, canRelease: false };
}
