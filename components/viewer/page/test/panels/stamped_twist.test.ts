import test from "node:test";
import assert from "node:assert/strict";
import { stampedTwist } from "../../src/panels/hands/stamped_twist";

const AHEAD = { linear: { x: 0.4, y: 0, z: 0 }, angular: { x: 0, y: 0, z: 0 } };

test("a command is stamped with the robot's time as it was heard last, not with this computer's", () => {
  const heard = 1000.25; // virtual time; this computer's clock is some 50 years on
  assert.deepEqual(stampedTwist(AHEAD, heard), { header: { stamp: { sec: 1000, nanosec: 250_000_000 }, frame_id: "" }, twist: AHEAD });
});

test("without a time of the robot nothing is commanded: a stamp of zero would say that the age does not matter", () => {
  assert.throws(() => stampedTwist(AHEAD, 0), /time is not known/);
  assert.throws(() => stampedTwist(AHEAD, Number.NaN), /time is not known/);
});
