import assert from "node:assert/strict";
import { test } from "node:test";
import { helpTopics, topicOf } from "../../src/page/help_topics";

const LIST = `# What stands here, and why: a comment.

Planners, and more:
dwa        components/local_planner/dwa/README.md   dynamic window approach
dwa/theory components/local_planner/dwa/theory.md   its objective

Start:
start      README.md   what it is
`;

test("a list is topics under headings", () => {
  const topics = helpTopics(LIST);
  assert.deepEqual(topics.map(({ group, name }) => [group, name]), [
    ["Planners, and more", "dwa"],
    ["Planners, and more", "dwa/theory"],
    ["Start", "start"],
  ]);
  assert.equal(topics[0]!.tells, "dynamic window approach");
});

test("a link leads to the topic of that page, from whatever folder, or nowhere", () => {
  const topics = helpTopics(LIST);
  const to = (file: string, href: string) => topicOf(topics, file, href);
  assert.equal(to("components/local_planner/dwa/README.md", "theory.md#terms"), "dwa/theory");
  assert.equal(to("components/local_planner/dwa/theory.md", "../../../README.md"), "start");
  assert.equal(to("README.md", "components/local_planner/dwa/"), "dwa");
  assert.equal(to("README.md", "components/local_planner/dwa"), "dwa");
  assert.equal(to("README.md", "https://example.org/README.md"), undefined);
  assert.equal(to("README.md", "src/main.cpp"), undefined);
});
