import assert from "node:assert/strict";
import test from "node:test";

import type { Message } from "../../src/app";
import { Follower } from "../../src/panels/follower";
import { timelineOf } from "./app";

const message = (time: number, value: string): Message => ({ topic: "/rosout", type: "", time, value });

test("each message once, also one of the same time and one that is older than its arrival", () => {
  const messages = [message(1, "a")];
  const follower = new Follower("/rosout");
  const taken = () => follower.take(timelineOf(messages, 2)).messages.map(({ value }) => value);
  assert.deepEqual(taken(), ["a"]);
  messages.push(message(1, "b"));
  messages.unshift(message(0.5, "latched"));
  assert.deepEqual(taken(), ["latched", "b"]);
  assert.deepEqual(taken(), []);
});

test("time that goes back is told", () => {
  const follower = new Follower("/rosout");
  assert.equal(follower.take(timelineOf([message(9, "old")], 10)).again, false);
  const { messages, again } = follower.take(timelineOf([message(1, "new")], 2));
  assert.equal(again, true);
  assert.deepEqual(messages.map(({ value }) => value), ["new"]);
});
