// Who brings the components of a graph up, in which order, and who follows whom.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/graph_files.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

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
