import assert from "node:assert/strict";
import test from "node:test";

import { ParameterStore, type Entry } from "../../src/panels/parameters/store";
import { toWire, Type, type Value } from "../../src/panels/parameters/values";
import { graphYaml, yamlValue } from "../../src/panels/parameters/yaml";

const NAMES: Record<string, [string, number, Value][]> = {
  "/local_planner": [
    ["teb.band.min_obstacle_dist", Type.double, 0.2],
    ["algorithm", Type.string, "eteb"],
  ],
  "/robot1/safety": [
    ["polygons.0.radius", Type.double, 1],
    ["polygons.0.points", Type.doubles, [0.5, 1]],
    ["polygons.1.radius", Type.double, 2],
    ["enabled", Type.boolean, true],
  ],
};

/** Nodes with NAMES; `refusal` by parameter. */
function storeOf(refusals: Record<string, string> = {}) {
  const changes: [string, Value][] = [];
  const calls: string[] = [];
  const answer = (service: string, request: any): unknown => {
    calls.push(service);
    const at = service.lastIndexOf("/");
    const parameters = NAMES[service.slice(0, at)];
    if (parameters === undefined) throw new Error(`There is no service ${service}`);
    switch (service.slice(at + 1)) {
      case "list_parameters":
        return { result: { names: parameters.map(([name]) => name), prefixes: [] } };
      case "describe_parameters":
        return {
          descriptors: parameters.map(([name, type]) => ({
            name, type, description: "", additional_constraints: "", read_only: false, floating_point_range: [], integer_range: [],
          })),
        };
      case "get_parameters":
        return { values: parameters.map(([, type, value]) => toWire(type, value)) };
      default: {
        const reason = refusals[request.parameters[0].name];
        return { result: { successful: reason === undefined, reason: reason ?? "" } };
      }
    }
  };
  const store = new ParameterStore(
    async <Response>(service: string, request: object) => answer(service, request) as Response,
    (entry: Entry) => changes.push([entry.parameter.name, entry.value]),
    () => {},
  );
  return { store, changes, calls };
}

async function loaded(refusals: Record<string, string> = {}) {
  const made = storeOf(refusals);
  await made.store.load(Object.keys(NAMES), (node, reason) => assert.fail(`${node}: ${reason}`));
  return made;
}

const yamlOf = (store: ParameterStore, hasRobots = true) => graphYaml(store.changed(), (node) => store.of(node), hasRobots);

test("every parameter of every node is known with its value", async () => {
  const { store } = await loaded();
  assert.deepEqual(store.nodes(), ["/local_planner", "/robot1/safety"]);
  assert.equal(store.find("/local_planner", "algorithm")?.value, "eteb");
  assert.deepEqual(store.changed(), []);
  assert.equal(yamlOf(store), "");
});

test("a node that does not answer is told, and the others are there", async () => {
  const { store } = storeOf();
  const failures: string[] = [];
  await store.load(["/gone", "/local_planner"], (node) => failures.push(node));
  assert.deepEqual(failures, ["/gone"]);
  assert.deepEqual(store.nodes(), ["/local_planner"]);
});

test("a change is sent as a whole, kept when it is taken, and listed against what was first", async () => {
  const { store, changes, calls } = await loaded();
  const entry = store.find("/local_planner", "teb.band.min_obstacle_dist")!;
  await store.set(entry, 0.4);
  assert.equal(calls.at(-1), "/local_planner/set_parameters_atomically");
  assert.deepEqual(changes, [["teb.band.min_obstacle_dist", 0.4]]);
  assert.deepEqual(store.changed(), [entry]);
  await store.set(entry, entry.first);
  assert.deepEqual(store.changed(), []);
});

test("a refusal has the node's reason and changes nothing", async () => {
  const { store, changes } = await loaded({ algorithm: "algorithm may not change while local_planner is active" });
  await assert.rejects(store.set(store.find("/local_planner", "algorithm")!, "dwa"), /may not change while/);
  assert.equal(store.find("/local_planner", "algorithm")!.value, "eteb");
  assert.deepEqual(changes, []);
});

test("changes by others are followed; of what is not known nothing is heard", async () => {
  const { store, changes } = await loaded();
  const event = (node: string, name: string) => ({
    node, new_parameters: [], changed_parameters: [{ name, value: toWire(Type.string, "dwa") as any }],
  });
  store.follow(event("/local_planner", "algorithm"));
  store.follow(event("/elsewhere", "algorithm"));
  assert.deepEqual(changes, [["algorithm", "dwa"]]);
  assert.equal(store.changed().length, 1);
});

test("a robot that is back with other values: they differ from what was first", async () => {
  const { store } = await loaded();
  const entry = store.find("/local_planner", "algorithm")!;
  await store.set(entry, "dwa");
  await store.load(["/local_planner"], (_, reason) => assert.fail(String(reason)));
  assert.deepEqual(store.changed(), []);
  assert.equal(store.find("/local_planner", "algorithm")!.value, "eteb");
});

test("changes are a part of a graph file, sections nested", async () => {
  const { store } = await loaded();
  await store.set(store.find("/local_planner", "teb.band.min_obstacle_dist")!, 1);
  assert.equal(
    yamlOf(store),
    ["components:", "  local_planner:", "    parameters:", "      teb:", "        band:", "          min_obstacle_dist: 1.0", ""].join("\n"),
  );
});

test("of several robots below the robot's name; a list whole, as a graph has it", async () => {
  const { store } = await loaded();
  await store.set(store.find("/robot1/safety", "polygons.1.radius")!, 2.5);
  assert.equal(
    yamlOf(store),
    [
      "robots:", "  robot1:", "    safety:", "      polygons:",
      "        - radius: 1.0", "          points: [0.5, 1.0]", "        - radius: 2.5", "",
    ].join("\n"),
  );
  assert.match(yamlOf(store, false), /^components:\n  safety:\n    parameters:\n      polygons:\n/);
});

test("texts that YAML would take for something else are quoted", () => {
  assert.equal(yamlValue(Type.string, "eteb"), "eteb");
  for (const text of ["true", "1.5", "", "a: b", "no", "#x", " x"]) assert.equal(yamlValue(Type.string, text), JSON.stringify(text));
  assert.equal(yamlValue(Type.double, Infinity), ".inf");
  assert.equal(yamlValue(Type.double, 1e-7), "1e-7");
  assert.equal(yamlValue(Type.integer, 3), "3");
  assert.equal(yamlValue(Type.strings, ["a", "yes"]), '[a, "yes"]');
});
