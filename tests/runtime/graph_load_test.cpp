// The graph file: what is read, and what is refused in which words.
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/graph/graph.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

/// A folder of files that lives as long as the test.
class Folder {
 public:
  Folder() {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    path_ = std::filesystem::path(testing::TempDir()) / (std::string("bw_graph_") + test->name());
    std::filesystem::create_directories(path_);
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((path_ / name).parent_path());
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// The refusal with the folder taken out of it.
std::string refusal(const std::string& yaml, const std::vector<std::string>& overrides = {}) {
  const Folder folder;
  const std::filesystem::path path = folder.write("g.yaml", yaml);
  try {
    load_graph(path, overrides);
  } catch (const ConfigError& error) {
    std::string text = error.what();
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }
  return "accepted";
}

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
  EXPECT_EQ(refusal("components:\n  world:\n    colour: a\n"),
            "g.yaml:3: components.world.colour: unknown key; known: type, process, lane, enabled, latency, "
            "manager, follows, namespace, shared, parameters, remap, inputs");
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
            "--set: x.y = 2: unknown component; known: robot, world");
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

TEST(LoadGraph, ReadsTheSnapshotSection) {
  const Folder folder;
  const Graph graph = load_graph(folder.write("graphs/g.yaml", R"(
snapshot:
  keep: 20s
  memory: 64MB
  most: 3
  to: ../misses
  on:
    - contact
    - /bumper
    - {name: empty, topic: /battery_state, field: percentage, below: 0.2}
components: {world: }
)"));
  ASSERT_TRUE(graph.snapshot);
  const SnapshotSettings& s = *graph.snapshot;
  EXPECT_EQ(s.keep, Duration::milliseconds(20'000));
  EXPECT_EQ(s.after, Duration::milliseconds(20'000));
  EXPECT_EQ(s.memory, 64'000'000U);
  EXPECT_EQ(s.most, 3);
  EXPECT_EQ(s.to, folder.path() / "misses");
  ASSERT_EQ(s.on.size(), 3U);
  EXPECT_EQ(s.on[0].name, "contact");
  EXPECT_FALSE(s.on[0].own);
  EXPECT_EQ(s.on[0].where.line, 8);
  EXPECT_EQ(s.on[1].own->topic, "/bumper");
  EXPECT_TRUE(s.on[1].own->when.empty());
  EXPECT_EQ(s.on[2].name, "empty");
  ASSERT_EQ(s.on[2].own->when.size(), 1U);
  EXPECT_EQ(s.on[2].own->when[0].field, "percentage");
  EXPECT_EQ(s.on[2].own->when[0].rule, EventRule::below);
  EXPECT_EQ(s.on[2].own->when[0].number, 0.2);
  EXPECT_FALSE(load_graph(folder.write("graphs/h.yaml", "components: {world: }")).snapshot);
}

TEST(LoadGraph, RefusesASnapshotSectionInWords) {
  const auto said = [](const std::string& section) {
    return refusal("snapshot: " + section + "\ncomponents: {world: }\n");
  };
  EXPECT_EQ(said("30s"),
            "g.yaml:1: snapshot = 30s: must be a map, such as {keep: 30s, on: [contact], to: snapshots}");
  EXPECT_EQ(said("{to: x, keep: soon}"),
            "g.yaml:1: snapshot.keep = soon: must be a duration between 1 s and 3600 s, such as 30s");
  EXPECT_EQ(said("{to: x, after: 2h}"),
            "g.yaml:1: snapshot.after = 2h: must be a duration between 0 s and 3600 s, such as 30s");
  EXPECT_EQ(said("{to: x, memory: 100kB}"),
            "g.yaml:1: snapshot.memory = 100kB: must be a size of at least 1MB, such as 256MB");
  EXPECT_EQ(said("{to: x, most: 0}"), "g.yaml:1: snapshot.most = 0: must be between 1 and 10000");
  EXPECT_EQ(said("{keep: 30s}"), "g.yaml:1: snapshot.to: must name a folder");
  EXPECT_EQ(said("{to: x, kep: 30s}"), "g.yaml:1: snapshot.kep: unknown key; did you mean 'keep'?");
  EXPECT_EQ(said("{to: x, on: contact}"), "g.yaml:1: snapshot.on = contact: must be a list");
  EXPECT_EQ(said("{to: x, on: []}"),
            "g.yaml:1: snapshot.on = a list: must name an event; without `on` every declared one counts");
  EXPECT_EQ(
      said("{to: x, on: [/a//b]}"),
      "g.yaml:1: snapshot.on = /a//b: must be a topic name: letters, digits and _ between single /, no digit "
      "after a /");
  EXPECT_EQ(said("{to: x, on: [{topic: a}]}"), "g.yaml:1: snapshot.on.topic = a: must begin with /");
  const std::string together =
      "g.yaml:1: snapshot.on.field = a map: and one of is, is_not, above, below, begins_with, rises come together";
  EXPECT_EQ(said("{to: x, on: [{topic: /a, field: b}]}"), together);
  EXPECT_EQ(said("{to: x, on: [{topic: /a, above: 1}]}"), together);
  EXPECT_EQ(said("{to: x, on: [{topic: /a, field: b, above: 1, below: 3}]}"), together);
  EXPECT_EQ(said("{to: x, on: [{topic: /a, field: b, above: high}]}"),
            "g.yaml:1: snapshot.on.above = high: must be a number");
}

std::vector<std::string> bring_up_of(const Graph& graph) {
  std::vector<std::string> names;
  for (const ComponentNode* node : graph.bring_up_order()) names.push_back(node->name);
  return names;
}

TEST(LoadGraph, ReadsLifecycleManagersAndTheOrderOfBringUp) {
  const Folder folder;
  const Graph graph = load_graph(folder.write("g.yaml", R"(
ros_distro: jazzy
lifecycle: external
bring_up: [map_server, amcl]
components:
  planner:
  amcl: {manager: localization}
  base: {manager: none}
  map_server: {manager: localization}
)"));
  EXPECT_TRUE(graph.settings.external_lifecycle);
  EXPECT_THAT(bring_up_of(graph), ElementsAre("map_server", "amcl", "planner", "base"));
  EXPECT_EQ(graph.find("planner")->manager, Manager::navigation);
  EXPECT_EQ(graph.find("amcl")->manager, Manager::localization);
  EXPECT_EQ(graph.find("base")->manager, Manager::none);

  const Graph plain = load_graph(folder.write("p.yaml", "components: {b: , a: }"));
  EXPECT_FALSE(plain.settings.external_lifecycle);
  EXPECT_THAT(bring_up_of(plain), ElementsAre("b", "a"));
}

TEST(LoadGraph, WhoFollowsComesUpBeforeItsLeader) {
  const Folder folder;
  const std::filesystem::path path = folder.write("g.yaml", R"(
bring_up: [controller]
components:
  planner:
  controller:
  local_costmap: {follows: controller}
  people: {follows: controller}
)");
  const Graph graph = load_graph(path);
  EXPECT_EQ(graph.find("people")->follows, "controller");
  EXPECT_THAT(bring_up_of(graph), ElementsAre("local_costmap", "people", "controller", "planner"));
  // What is left out is not brought up by its leader.
  EXPECT_EQ(load_graph(path, {"people.enabled=false"}).followers_of("controller").size(), 1U);
}

TEST(LoadGraph, RefusesToFollowWhatCannotLead) {
  const std::string text = refusal(R"(bring_up: [b]
components:
  a:
  b: {follows: a, manager: none}
  c: {follows: b}
  d: {follows: d}
  e: {follows: aa}
  f: {follows: a, process: other}
  g: {enabled: false}
  h: {follows: g}
)");
  const auto refuses = [&text](const std::string& part) { EXPECT_THAT(text, ::testing::HasSubstr(part)); };
  refuses("g.yaml:4: bring_up = b: must not name who follows: it comes up with its leader");
  refuses("g.yaml:4: components.b.manager = none: must not be given beside follows");
  refuses("g.yaml:5: components.c.follows = b: must be a component that follows none");
  refuses("g.yaml:6: components.d.follows = d: must be a component that follows none");
  refuses("g.yaml:7: components.e.follows = aa: unknown component; did you mean 'a'?");
  refuses("g.yaml:8: components.f.follows = a: must be in the same process");
  refuses("g.yaml:10: components.h.follows = g: must be enabled where its follower is");
}

// What waits for a manager starts before the others on the domain, and would guess.
TEST(LoadGraph, AGraphWithAManagerFromOutsideNamesItsDistro) {
  const std::string rule =
      "ros_distro = auto: must be named beside lifecycle: external: humble, jazzy, kilted or lyrical, as the manager's is; "
      "messages of nav2_msgs differ from each to the next";
  EXPECT_EQ(refusal("components: {a: }\nros_distro: auto\nlifecycle: external\n"), "g.yaml:2: " + rule);
  EXPECT_EQ(refusal("components: {a: }\n\nlifecycle: external\n"), "g.yaml:3: " + rule);
  EXPECT_EQ(refusal("components: {a: }\nros_distro: auto\nlifecycle: own\n"), "accepted");
  EXPECT_EQ(refusal("components: {a: }\nros_distro: kilted\nlifecycle: external\n"), "accepted");
  EXPECT_EQ(refusal("components: {a: }\nlifecycle: external\n", {"ros_distro=humble"}), "accepted");
  EXPECT_THAT(refusal("components: {a: }\n", {"ros_distro=jazy"}),
              ::testing::HasSubstr("ros_distro = jazy: must be one of auto, humble"));
  const Folder folder;
  const auto path = folder.write("set.yaml", "components: {a: }\nros_distro: jazzy\n");
  EXPECT_EQ(load_graph(path, {"ros_distro=humble"}).settings.ros_distro, RosDistro::humble);
}

TEST(LoadGraph, RefusesABringUpThatIsNotOfThisGraph) {
  const std::string text = refusal(R"(lifecycle: ours
bring_up:
  - planer
  - planner
  - planner
components:
  planner: {manager: nav}
)");
  EXPECT_THAT(text, ::testing::HasSubstr("g.yaml:1: lifecycle = ours: must be one of own, external"));
  EXPECT_THAT(
      text, ::testing::HasSubstr("g.yaml:3: bring_up = planer: unknown component; did you mean 'planner'?"));
  EXPECT_THAT(text, ::testing::HasSubstr("g.yaml:5: bring_up = planner: must be named once"));
  EXPECT_THAT(text, ::testing::HasSubstr("g.yaml:7: components.planner.manager = nav: must be one of"));
  EXPECT_THAT(refusal("bring_up: planner\ncomponents: {planner: }"), ::testing::HasSubstr("bring_up"));
}

}  // namespace
}  // namespace bw
