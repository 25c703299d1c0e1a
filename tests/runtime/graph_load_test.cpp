// The graph file: what is read, and what is refused in which words.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/graph_files.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

TEST(LoadGraph, ReadsEverythingItNames) {
  const Folder folder;
  folder.write("robots/r.yaml", "radius: 0.2\n");
  folder.write("planners/p.yaml", "horizon: 3\n");
  const Graph graph = load_graph(folder.write("graphs/g.yaml", R"(
ros_distro: humble
namespace: house
frame_prefix: robot1/
transport: lan
plugins: [lib/own.so]
robot: ../robots/r.yaml
components:
  world:
    process: world+base
    parameters: {seed: 4}
  planner:
    type: local_planner
    process: planning
    lane: planner
    latency: 20ms
    namespace: robot1
    parameters: ../planners/p.yaml
    remap: {cmd_vel_nav: cmd_vel, ~/debug: /debug}
    inputs:
      odom: {max_age: 500 ms, on_stale: degrade}
      tracks: {external: true}
  base:
    process: world+base
    namespace: /robot2
)"),
                                 {"planner.weights.speed=2", "robot.radius=0.25", "base.port=/dev/ttyUSB0"});

  EXPECT_EQ(graph.settings.ros_distro, RosDistro::humble);
  EXPECT_EQ(graph.settings.frame_prefix, "robot1/");
  EXPECT_EQ(graph.settings.transport, "lan");
  EXPECT_THAT(graph.settings.plugins, ElementsAre((folder.path() / "graphs/lib/own.so").string()));
  EXPECT_EQ(graph.shared.at("robot").find("radius")->scalar, "0.25");
  EXPECT_THAT(graph.processes(), ElementsAre("world+base", "planning"));

  ASSERT_EQ(graph.components.size(), 3U);
  const ComponentNode& world = graph.components[0];
  EXPECT_EQ(world.type, "world");
  EXPECT_EQ(world.lane, "main");
  EXPECT_EQ(world.latency, Duration{});
  EXPECT_EQ(world.node_namespace, "/house");
  EXPECT_EQ(world.where.line, 9);

  const ComponentNode& planner = graph.components[1];
  EXPECT_EQ(planner.type, "local_planner");
  EXPECT_EQ(planner.lane, "planner");
  EXPECT_EQ(planner.latency, Duration::milliseconds(20));
  EXPECT_EQ(planner.node_namespace, "/house/robot1");
  EXPECT_EQ(planner.parameters.find("horizon")->where.file, (folder.path() / "planners/p.yaml").string());
  EXPECT_EQ(find_dotted(planner.parameters, "weights.speed")->scalar, "2");
  EXPECT_EQ(planner.topic_of("cmd_vel_nav"), "/house/robot1/cmd_vel");
  EXPECT_EQ(planner.topic_of("~/debug"), "/debug");
  EXPECT_EQ(planner.input("odom")->max_age, Duration::milliseconds(500));
  EXPECT_EQ(planner.input("odom")->on_stale, OnStale::degrade);
  EXPECT_FALSE(planner.input("odom")->external);
  EXPECT_TRUE(planner.input("tracks")->external);
  EXPECT_EQ(planner.input("tracks")->max_age, std::nullopt);
  EXPECT_EQ(planner.input("scan"), nullptr);

  EXPECT_EQ(graph.find("base")->node_namespace, "/robot2");
  EXPECT_EQ(graph.find("base")->parameters.find("port")->scalar, "/dev/ttyUSB0");
}

TEST(LoadGraph, GivesEachRobotTheComponentsThatAreNotShared) {
  const Folder folder;
  const Graph graph = load_graph(
      folder.write("g.yaml", R"(
namespace: house
robots:
  robot1: {planner: {goal: {x: 9}, speed: 2}}
  robot2:
bring_up: [planner]
components:
  world: {shared: true, process: world}
  planner:
    process: planning
    lane: slow
    namespace: inner
    parameters: {goal: {x: 1, y: 2}, speed: 1}
    remap: {out: /all}
  base:
)"),
      {"planner.goal.y=3", "robot2/planner.speed=5", "base.enabled=false", "robot1/base.enabled=true"});
  std::vector<std::string> names;
  for (const ComponentNode& node : graph.components) names.push_back(node.name);
  EXPECT_THAT(names, ElementsAre("world", "robot1/planner", "robot2/planner", "robot1/base", "robot2/base"));
  EXPECT_THAT(graph.robots, ElementsAre("robot1", "robot2"));
  EXPECT_THAT(graph.processes(),
              ElementsAre("world", "robot1-planning", "robot2-planning", "robot1", "robot2"));
  EXPECT_THAT(graph.bring_up, ElementsAre("robot1/planner", "robot2/planner"));

  EXPECT_EQ(graph.find("world")->robot, "");
  EXPECT_EQ(graph.find("world")->topic_of("scan"), "/house/scan");
  const ComponentNode& one = *graph.find("robot1/planner");
  EXPECT_EQ(one.robot, "robot1");
  EXPECT_EQ(one.type, "planner");
  EXPECT_EQ(one.node_name(), "planner");
  EXPECT_EQ(one.node_namespace, "/house/robot1/inner");
  EXPECT_EQ(one.lane, "robot1-slow");
  EXPECT_EQ(one.topic_of("~/debug"), "/house/robot1/inner/planner/debug");
  EXPECT_EQ(one.topic_of("out"), "/all");
  EXPECT_EQ(find_dotted(one.parameters, "goal.x")->scalar, "9");
  EXPECT_EQ(find_dotted(one.parameters, "goal.y")->scalar, "3");
  EXPECT_EQ(find_dotted(one.parameters, "speed")->scalar, "2");
  const ComponentNode& two = *graph.find("robot2/planner");
  EXPECT_EQ(find_dotted(two.parameters, "goal.x")->scalar, "1");
  EXPECT_EQ(find_dotted(two.parameters, "speed")->scalar, "5");
  EXPECT_TRUE(graph.find("robot1/base")->enabled);
  EXPECT_FALSE(graph.find("robot2/base")->enabled);
  EXPECT_EQ(graph.find("robot2/base")->node_namespace, "/house/robot2");
}

TEST(LoadGraph, RefusesRobotsThatItCannotTellApart) {
  const std::string components = "components: {world: {shared: true}, base: }\n";
  EXPECT_EQ(refusal("robots: [a, b]\n" + components),
            "g.yaml:1: robots = a list: must be a map of parameters");
  EXPECT_EQ(refusal("robots: {a-b: }\n" + components),
            "g.yaml:1: robots.a-b: must be a node name: letters, digits and _, no digit first");
  EXPECT_EQ(refusal("robots: {a: {bases: {x: 1}}}\n" + components),
            "g.yaml:1: robots.a.bases: unknown component; did you mean 'base'?");
  EXPECT_EQ(refusal("robots: {a: {world: {x: 1}}}\n" + components),
            "g.yaml:1: robots.a.world: is one for all robots: its parameters stand with it");
  EXPECT_EQ(refusal("robots: {a: {base: 3}}\n" + components),
            "g.yaml:1: robots.a.base = 3: must be a map of parameters");
  EXPECT_EQ(
      refusal("namespace: house\nrobots: {a: , b: }\ncomponents: {base: {namespace: /x}}\n"),
      "g.yaml:3: components.base.namespace = /x: must be relative where there are robots: each has this "
      "component");
}

TEST(LoadGraph, RefusesUnknownKeysWithTheNearestKnown) {
  EXPECT_EQ(
      refusal("component:\n  world:\n"),
      "g.yaml:1: components: must be given\ng.yaml:1: component: unknown key; did you mean 'components'?");
  EXPECT_EQ(refusal("components:\n  world:\n    proces: a\n"),
            "g.yaml:3: components.world.proces: unknown key; did you mean 'process'?");
  EXPECT_EQ(refusal("components:\n  world:\n    inputs:\n      odom: {maxage: 1}\n"),
            "g.yaml:4: components.world.inputs.odom.maxage: unknown key; did you mean 'max_age'?");
  EXPECT_EQ(
      refusal("components:\n  world:\n    colour: a\n"),
      "g.yaml:3: components.world.colour: unknown key; known: type, process, lane, priority, enabled, latency, "
      "manager, follows, namespace, shared, parameters, remap, emulation, inputs");
}

TEST(LoadGraph, RefusesWrongValues) {
  EXPECT_EQ(refusal("ros_distro: iron\ncomponents: {a: }"),
            "g.yaml:1: ros_distro = iron: must be one of auto, humble, jazzy, kilted, lyrical");
  EXPECT_EQ(refusal("transport: [wifi]\ncomponents: {a: }"), "g.yaml:1: transport = a list: must be text");
  EXPECT_EQ(refusal("namespace: a//b\ncomponents: {a: }"),
            "g.yaml:1: namespace = a//b: must be a namespace: letters, digits and _ between single /, no "
            "digit after a /");
  EXPECT_EQ(refusal("frame_prefix: /a\ncomponents: {a: }"),
            "g.yaml:1: frame_prefix = /a: must be a prefix of frame names, such as robot1_ or robot1/");
  EXPECT_EQ(refusal("components:\n"), "g.yaml:1: components = nothing: must be a map of components");
  EXPECT_EQ(refusal("components: [a]"), "g.yaml:1: components = a list: must be a map of components");
  EXPECT_EQ(refusal(""), "g.yaml:1: must be a map with the key components");
  EXPECT_EQ(refusal("components:\n  a: 3\n"), "g.yaml:2: components.a = 3: must be a map");
  EXPECT_EQ(refusal("components:\n  a-b:\n"),
            "g.yaml:2: components.a-b: must be a node name: letters, digits and _, no digit first");
  EXPECT_EQ(refusal("components:\n  robot:\n"),
            "g.yaml:2: components.robot: must not be the name of a shared section");
  EXPECT_EQ(refusal("components:\n  a:\n  a:\n"), "g.yaml:3: components.a: this key is given twice");
  EXPECT_EQ(refusal("components: {a: {latency: 20 parsecs}}"),
            "g.yaml:1: components.a.latency = 20 parsecs: must be a duration, such as 20ms, 0.5s or a number "
            "of seconds");
  EXPECT_EQ(refusal("components: {a: {latency: -1ms}}"),
            "g.yaml:1: components.a.latency = -1ms: must be between 0 and 10 s");
  EXPECT_EQ(refusal("components: {a: {process: a b}}"),
            "g.yaml:1: components.a.process = a b: must be a name: at most 64 letters, digits, _, - and +");
  EXPECT_EQ(
      refusal("components: {a: {remap: {x: 1y}}}"),
      "g.yaml:1: components.a.remap.x = 1y: must be a topic name: letters, digits and _ between single /, no "
      "digit after a /");
  EXPECT_EQ(refusal("components: {a: {inputs: {x: {max_age: 0}}}}"),
            "g.yaml:1: components.a.inputs.x.max_age = 0: must be between 0.001 and 3600 s");
  EXPECT_EQ(refusal("components: {a: {inputs: {x: {on_stale: stop}}}}"),
            "g.yaml:1: components.a.inputs.x.on_stale = stop: needs a max_age beside it");
  EXPECT_EQ(refusal("components: {a: {inputs: [x]}}"),
            "g.yaml:1: components.a.inputs = a list: must be a map of parameters");
}

TEST(LoadGraph, RefusesFilesThatAreNotThere) {
  EXPECT_EQ(refusal("components:\n  a:\n    parameters: p.yaml\n"),
            "g.yaml:3: components.a.parameters = p.yaml: p.yaml: no such file");
  EXPECT_EQ(refusal("robot: r.yaml\ncomponents: {a: }"), "g.yaml:1: robot = r.yaml: r.yaml: no such file");
  EXPECT_EQ(refusal("robot: [1]\ncomponents: {a: }"),
            "g.yaml:1: robot = a list: must be a map or the path of a YAML file");
}

TEST(LoadGraph, LocatesViolationsInsideOtherFiles) {
  const Folder folder;
  folder.write("p.yaml", "a: 1\na: 2\n");
  const auto path = folder.write("g.yaml", "components: {w: {parameters: p.yaml}}");
  EXPECT_THAT([&] { load_graph(path); },
              testing::ThrowsMessage<ConfigError>((folder.path() / "p.yaml").string() +
                                                  ":2: a: this key is given twice"));
}

TEST(LoadGraph, SwitchesComponentsOffAndOn) {
  const Folder folder;
  const auto path = folder.write("g.yaml", "components: {a: {enabled: false}, b: }");
  const auto enabled = [&](const std::vector<std::string>& overrides) {
    const Graph graph = load_graph(path, overrides);
    return std::pair(graph.find("a")->enabled, graph.find("b")->enabled);
  };
  EXPECT_EQ(enabled({}), std::pair(false, true));
  EXPECT_EQ(enabled({"a.enabled=true", "b.enabled=false"}), std::pair(true, false));
  EXPECT_EQ(refusal("components: {a: }", {"a.enabled=maybe"}),
            "--set: a.enabled = maybe: must be true or false");
  EXPECT_EQ(refusal("components: {a: {enabled: 2}}"),
            "g.yaml:1: components.a.enabled = 2: must be true or false");
}

TEST(LoadGraph, RefusesOverridesOfWhatIsNotThere) {
  EXPECT_EQ(refusal("components: {world: }", {"wrold.seed=1"}),
            "--set: wrold.seed = 1: unknown component; did you mean 'world'?");
  EXPECT_EQ(refusal("components: {world: }", {"world=1"}),
            "--set: world = 1: must have the form component.param=value");
  EXPECT_EQ(refusal("components: {world: {parameters: {a: 1}}}", {"world.a.b=1", "x.y=2", "world.c=3"}),
            "--set: world.a.b = 1: 'a' has no parts, it is 1\n"
            "--set: x.y = 2: unknown component; known: robot, faults, world");
}

TEST(ResolveName, FollowsTheRulesOfRos) {
  EXPECT_EQ(resolve_name("/", "node", "odom"), "/odom");
  EXPECT_EQ(resolve_name("/r1", "node", "odom"), "/r1/odom");
  EXPECT_EQ(resolve_name("/r1", "node", "a/b"), "/r1/a/b");
  EXPECT_EQ(resolve_name("/r1", "node", "/odom"), "/odom");
  EXPECT_EQ(resolve_name("/r1", "node", "~/debug"), "/r1/node/debug");
  EXPECT_EQ(resolve_name("/r1/costmap", "node", "../map"), "/r1/map");
  EXPECT_EQ(resolve_name("/costmap", "node", "../map"), "/map");
  EXPECT_EQ(resolve_name("/", "node", "../map"), "/map");
  EXPECT_EQ(resolve_name("/r1", "node", "odom", {{"odom", "pose/odom", {}}}), "/r1/pose/odom");
  EXPECT_EQ(resolve_name("/r1", "node", "odom", {{"/r1/odom", "/odom", {}}}), "/odom");
  EXPECT_EQ(resolve_name("/r1", "node", "a", {{"a", "b", {}}, {"b", "c", {}}}), "/r1/b");
  EXPECT_EQ(join_namespaces("", ""), "/");
  EXPECT_EQ(join_namespaces("/", "a"), "/a");
  EXPECT_EQ(join_namespaces("a", "b/"), "/a/b");
}

TEST(TopicNameRule, AcceptsWhatRosAccepts) {
  for (const std::string good : {"odom", "/odom", "~/a", "a/b_2", "/_a"}) {
    EXPECT_EQ(topic_name_rule(good), std::nullopt) << good;
  }
  for (const std::string bad :
       {"", "/", "~", "~a", "/~/a", "a//b", "a/", "2a", "a/2b", "a b", "a-b", "\xc3\xa9"}) {
    EXPECT_NE(topic_name_rule(bad), std::nullopt) << bad;
  }
  EXPECT_EQ(topic_name_rule(std::string(247, 'a')), std::nullopt);
  EXPECT_EQ(topic_name_rule(std::string(248, 'a')), "must be at most 247 characters long");
}

TEST(LoadGraph, ReadsWhatEachProcessMayTake) {
  const Folder folder;
  const Graph graph = load_graph(folder.write("g.yaml", R"(
processes: {planning: {memory: 800MB, cpu: 1.5}, rest: {}}
components: {a: {process: planning}, b: {process: rest}}
)"));
  EXPECT_EQ(graph.limits.at("planning").memory, 800'000'000U);
  EXPECT_EQ(graph.limits.at("planning").cpu, 1.5);
  EXPECT_FALSE(graph.limits.at("rest").memory);
  EXPECT_FALSE(graph.limits.at("rest").cpu);
  const auto said = [](const std::string& section) {
    return refusal("processes: " + section + "\ncomponents: {a: {process: planning}}\n");
  };
  EXPECT_EQ(said("{planing: {}}"), "g.yaml:1: processes.planing: unknown process; did you mean 'planning'?");
  EXPECT_EQ(said("{planning: {memory: 1MB}}"),
            "g.yaml:1: processes.planning.memory = 1MB: must be a size of at least 100MB, such as 800MB");
  EXPECT_EQ(said("{planning: {cpu: 0}}"),
            "g.yaml:1: processes.planning.cpu = 0: must be between 0.05 and 1024 cores");
  EXPECT_EQ(said("{planning: {cores: 2}}"),
            "g.yaml:1: processes.planning.cores: unknown key; known: memory, cpu");
}

TEST(LoadGraph, PutsAComponentIntoAnotherProcess) {
  const Folder folder;
  const auto path = folder.write("g.yaml", "components: {a: {process: one}, b: {process: one}}\n");
  const Graph graph = load_graph(path, {"a.process=two"});
  EXPECT_EQ(graph.find("a")->process, "two");
  EXPECT_EQ(graph.find("b")->process, "one");
  EXPECT_THROW(static_cast<void>(load_graph(path, {"a.process=no name"})), ConfigError);
}

}  // namespace
}  // namespace bw
