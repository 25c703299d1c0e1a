import assert from "node:assert/strict";
import test from "node:test";

import { Driver, PERIOD_MS, type Twist } from "../../src/panels/hands/driver";

/** A driver whose clock is moved by hand, and what it sent: speed, turn rate. */
function driverOf(send: (twist: Twist) => Promise<void> = async () => {}) {
  const sent: [number, number][] = [];
  const failures: unknown[] = [];
  let tick: (() => void) | undefined;
  const clockwork = {
    every(ms: number, work: () => void) {
      assert.equal(ms, PERIOD_MS);
      tick = work;
      return () => (tick = undefined);
    },
  };
  const driver = new Driver(
    (twist) => {
      sent.push([twist.linear.x, twist.angular.z]);
      return send(twist);
    },
    () => ({ linear: 0.5, angular: 1 }),
    clockwork,
    (reason) => failures.push(reason),
  );
  const passes = async () => {
    tick?.();
    await new Promise((resolve) => setImmediate(resolve));
  };
  return { driver, sent, failures, passes, isTicking: () => tick !== undefined };
}

test("three commands fit into the 200 ms that one counts, at 10 to 20 Hz", () => {
  assert.ok(PERIOD_MS * 3 <= 200);
  assert.ok(1000 / PERIOD_MS >= 10 && 1000 / PERIOD_MS <= 20);
});

test("a held key drives at once and goes on; released it says zero at once, and no more", async () => {
  const { driver, sent, passes, isTicking } = driverOf();
  driver.press("KeyW", "forward");
  assert.deepEqual(sent, [[0.5, 0]]);
  await passes();
  await passes();
  assert.equal(sent.length, 3);
  driver.release("KeyW");
  assert.deepEqual(sent.at(-1), [0, 0]);
  assert.equal(isTicking(), false);
  assert.equal(sent.length, 4);
});

test("keys add up, opposite ones cancel, and each is let go of by itself", () => {
  const { driver, sent } = driverOf();
  driver.press("KeyW", "forward");
  driver.press("KeyA", "left");
  assert.deepEqual(sent.at(-1), [0.5, 1]);
  driver.press("KeyS", "backward");
  assert.deepEqual(sent.at(-1), [0, 1]);
  driver.release("KeyW");
  assert.deepEqual(sent.at(-1), [-0.5, 1]);
  driver.releaseAll();
  assert.deepEqual(sent.at(-1), [0, 0]);
  assert.equal(driver.isDriving, false);
});

test("a key that repeats says nothing new, and one that was not held ends nothing", () => {
  const { driver, sent } = driverOf();
  driver.press("KeyW", "forward");
  driver.press("KeyW", "forward");
  assert.equal(sent.length, 1);
  driver.release("KeyQ");
  assert.equal(sent.length, 1);
  assert.equal(driver.isDriving, true);
});

test("a refused command lets go of everything and says why, once", async () => {
  const { driver, failures, isTicking, passes } = driverOf(() => Promise.reject(new Error("another one commands")));
  driver.press("KeyW", "forward");
  await passes();
  assert.equal(driver.isDriving, false);
  assert.equal(isTicking(), false);
  assert.deepEqual(failures.map(String), ["Error: another one commands"]);
});

test("a connection that takes nothing gets no queue: two commands wait at most, and the zero", async () => {
  const { driver, sent, passes } = driverOf(() => new Promise(() => {}));
  driver.press("KeyW", "forward");
  for (let i = 0; i < 10; i++) await passes();
  assert.equal(sent.length, 2);
  driver.release("KeyW");
  assert.deepEqual(sent.at(-1), [0, 0]);
});
