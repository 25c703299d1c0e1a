import assert from "node:assert/strict";
import test from "node:test";

import { componentOf, parameterOf, sectionOf, type Descriptor } from "../../src/panels/parameters/descriptor";
import { matcher } from "../../src/panels/parameters/search";

const NONE: Descriptor = {
  name: "x",
  type: 3,
  description: "",
  additional_constraints: "",
  read_only: false,
  floating_point_range: [],
  integer_range: [],
};

test("unit, documentation, range and default as the nodes write them", () => {
  const parameter = parameterOf("/local_planner", {
    ...NONE,
    name: "teb.band.min_obstacle_dist",
    description: "wanted gap between footprint and obstacle; lower it for narrow doors [m]",
    additional_constraints: "default 0.2",
    floating_point_range: [{ from_value: 0, to_value: 10 }],
  });
  assert.equal(parameter.unit, "m");
  assert.equal(parameter.doc, "wanted gap between footprint and obstacle; lower it for narrow doors");
  assert.deepEqual(parameter.range, { from: 0, to: 10 });
  assert.equal(parameter.defaultValue, 0.2);
  assert.equal(parameter.rule, "");
});

test("choices and their default", () => {
  const parameter = parameterOf("/local_planner", { ...NONE, type: 4, additional_constraints: "must be one of dwa, eteb; default eteb" });
  assert.deepEqual(parameter.choices, ["dwa", "eteb"]);
  assert.equal(parameter.defaultValue, "eteb");
});

test("a list's default, and a rule beside it", () => {
  const parameter = parameterOf("/n", { ...NONE, type: 8, additional_constraints: "each element must be at least 0 m; default [1, 2.5]" });
  assert.deepEqual(parameter.defaultValue, [1, 2.5]);
  assert.equal(parameter.rule, "each element must be at least 0 m");
});

test("without unit, documentation or default there is none", () => {
  const parameter = parameterOf("/n", { ...NONE, description: "[m/s]" });
  assert.deepEqual([parameter.unit, parameter.doc, parameter.defaultValue], ["m/s", "", undefined]);
  assert.equal(parameterOf("/n", { ...NONE, description: "no unit" }).doc, "no unit");
});

test("an open end is no end of a slider; integers have 64 bits", () => {
  const open = [{ from_value: 0, to_value: Number.MAX_VALUE }];
  assert.equal(parameterOf("/n", { ...NONE, floating_point_range: open }).range, undefined);
  const integer = [{ from_value: 1n, to_value: 100n }];
  assert.deepEqual(parameterOf("/n", { ...NONE, type: 2, integer_range: integer }).range, { from: 1, to: 100 });
});

test("names have their component, robot and section", () => {
  assert.deepEqual(componentOf("/people"), { robot: "", component: "people" });
  assert.deepEqual(componentOf("/robot1/people"), { robot: "robot1", component: "people" });
  assert.deepEqual(componentOf("/global_costmap/global_costmap"), { robot: "", component: "global_costmap" });
  assert.deepEqual(componentOf("/robot1/global_costmap/global_costmap"), { robot: "robot1", component: "global_costmap" });
  assert.deepEqual(sectionOf("teb.band.dt_ref"), { section: "teb.band", leaf: "dt_ref" });
  assert.deepEqual(sectionOf("algorithm"), { section: "", leaf: "algorithm" });
});

test("a search finds words of name, unit and documentation, all of them", () => {
  const parameter = parameterOf("/local_planner", { ...NONE, name: "teb.weight", description: "how much people count [1/m]" });
  assert.ok(matcher("people WEIGHT")(parameter));
  assert.ok(matcher("1/m")(parameter));
  assert.ok(!matcher("people speed")(parameter));
  assert.ok(matcher("")(parameter));
});
