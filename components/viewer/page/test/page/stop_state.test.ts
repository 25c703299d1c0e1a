import assert from "node:assert/strict";
import test from "node:test";
import { stopState } from "../../src/page/stop_state";

const base = (state: number, is_latched: boolean, reason = "") => ({ state, is_latched, reason });

test("a base that is not heard is told of", () => {
  assert.deepEqual(stopState(undefined, false), { text: "base_state is not heard", isInForce: false, canRelease: false });
});

test("an emergency stop is in force when it is latched", () => {
  assert.deepEqual(stopState(base(3, true, "pressed by /a"), false), { text: "Stopped: pressed by /a", isInForce: true, canRelease: true });
  assert.equal(stopState(base(3, false), false).isInForce, false);
  assert.equal(stopState(base(0, false), false).isInForce, false);
});

test("what is latched can be released, what is over by itself cannot", () => {
  assert.equal(stopState(base(4, true, "bumper: left"), false).canRelease, true);
  assert.equal(stopState(base(12, false, "the charger is connected"), false).canRelease, false);
  assert.equal(stopState(base(2, true, "bumper: left"), false).text, "Stopped: bumper: left"); // it backs off
});

test("it says what becomes of the goal while the base stands", () => {
  const goal = (status: number, reason = "") => ({ goal_id: 3, status, reason });
  const bumper = base(4, true, "bumper: left");
  assert.equal(stopState(bumper, false, goal(2)).text, "Stopped: bumper: left. Goal 3 waits for the release");
  assert.equal(stopState(base(12, false, "the charger is connected"), false, goal(1)).text, "Stopped: the charger is connected. Goal 3 waits");
  const refused = goal(6, "the base stands: bumper: left; until release_stop");
  assert.equal(stopState(bumper, false, refused).text, "Stopped: bumper: left. Goal 3 was not taken");
  assert.equal(stopState(bumper, false, goal(4, "reached")).text, "Stopped: bumper: left");
  assert.equal(stopState(base(1, false), false, refused).text, ""); // the base obeys again
});

test("whoever a hand interrupted waits for a release", () => {
  assert.deepEqual(stopState(base(1, false), true), {
    text: "Interrupted by a hand: waits for a release",
    isInForce: false,
    canRelease: true,
  });
  assert.equal(stopState(base(0, false), false).text, "");
});
