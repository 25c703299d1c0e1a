// `bandwagon param` on the nodes of a running graph, as `ros2 param` does it.
#include <filesystem>
#include <fstream>
#include <memory>

#include <gmock/gmock.h>

#include "tests/interop/running_graph.hpp"

namespace bw::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class Param : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    graph_ = std::make_unique<RunningGraph>(std::filesystem::path(BANDWAGON_SOURCE_DIR) /
                                            "config/graphs/hallway.yaml");
  }
  static void TearDownTestSuite() {
    EXPECT_EQ(graph_->stop(), 0) << graph_->process().err();
    graph_.reset();
  }
  static Outcome param(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {BANDWAGON_PROGRAM, "param"});
    return run_to_end(arguments, std::chrono::seconds(60));
  }

  static std::unique_ptr<RunningGraph> graph_;
};

std::unique_ptr<RunningGraph> Param::graph_;

TEST_F(Param, ListNamesTheParametersOfEveryNode) {
  const Outcome list = param({"list"});
  EXPECT_EQ(list.status, 0) << list.err;
  for (const char* part : {"/local_planner:\n  algorithm\n", ":\n  use_sim_time\n", "/world:\n",
                           "  teb.band.min_obstacle_dist\n", "  robot.limits.v_max\n"}) {
    EXPECT_THAT(list.out, HasSubstr(part));
  }
  const Outcome one = param({"list", "local_planner"});
  EXPECT_EQ(one.status, 0) << one.err;
  EXPECT_THAT(one.out, StartsWith("  algorithm\n  controller_frequency\n"));
}

TEST_F(Param, SetChangesWhatGetTells) {
  const Outcome set = param({"set", "/local_planner", "back_off_margin", "0.25"});
  EXPECT_EQ(set.status, 0) << set.err;
  EXPECT_EQ(set.out, "Set parameter successful\n");
  EXPECT_EQ(param({"get", "/local_planner", "back_off_margin"}).out, "Double value is: 0.25\n");
  EXPECT_EQ(param({"get", "/local_planner", "algorithm"}).out, "String value is: eteb\n");
  EXPECT_EQ(param({"get", "local_planner", "use_sim_time"}).out, "Boolean value is: false\n");
}

// As Nav2's users give it; what is accepted every component is told (tests/components/footprints).
TEST_F(Param, AFootprintIsGivenAsAListAndIsAText) {
  const std::string rectangle = "[[0.3, 0.2], [-0.3, 0.2], [-0.3, -0.2], [0.3, -0.2]]";
  const Outcome set = param({"set", "/local_costmap", "footprint", rectangle});
  EXPECT_EQ(set.out, "Set parameter successful\n") << set.err;
  EXPECT_THAT(param({"get", "/local_costmap", "footprint"}).out, HasSubstr(rectangle));
  const Outcome told = run_to_end({BANDWAGON_PROGRAM, "topic", "echo", "/robot_footprint", "--once"},
                                  std::chrono::seconds(60));
  EXPECT_THAT(told.out, HasSubstr("frame_id: base_link"));
  EXPECT_THAT(told.out, HasSubstr("x: 0.3"));
  const Outcome arrow =
      param({"set", "/local_costmap", "footprint", "[[0.5, 0.0], [-0.5, 0.4], [-0.2, 0.0], [-0.5, -0.4]]"});
  EXPECT_EQ(arrow.status, 1);
  EXPECT_THAT(arrow.err, HasSubstr("must be convex: the outline turns inwards at a corner"));
  EXPECT_EQ(param({"set", "/local_costmap", "footprint", "\"\""}).status, 0);
}

TEST_F(Param, SetSaysWhyNot) {
  const auto refusal = [](const std::string& name, const std::string& value) {
    const Outcome set = param({"set", "/local_planner", name, value});
    EXPECT_EQ(set.status, 1);
    return set.err;
  };
  EXPECT_EQ(refusal("back_off_margin", "1"),
            "Setting parameter failed: back_off_margin expects a double, got an integer: write 1.0\n");
  EXPECT_EQ(refusal("back_off_margin", "3.0"),
            "Setting parameter failed: back_off_margin = 3.0: must be between 0 and 2 m\n");
  EXPECT_EQ(
      refusal("bakc_off_margin", "1.0"),
      "Setting parameter failed: unknown parameter 'bakc_off_margin'; did you mean 'back_off_margin'?\n");
  EXPECT_EQ(
      refusal("algorithm", "dwa"),
      "Setting parameter failed: algorithm may not change while local_planner is active; deactivate and clean up "
      "first\n");
  EXPECT_THAT(refusal("robot.radius", "0.1"), HasSubstr("robot.radius is read-only"));
}

TEST_F(Param, DescribeTellsRangeAndWhetherItMayChange) {
  EXPECT_EQ(param({"describe", "/local_planner", "back_off_margin"}).out,
            "Parameter name: back_off_margin\n  Type: double\n"
            "  Description: clearance kept behind the footprint while backing off [m]\n"
            "  Constraints:\n    Read only: false\n    Min value: 0.0\n    Max value: 2.0\n"
            "    Additional constraints: default 0.15\n");
  const Outcome fixed = param({"describe", "/local_planner", "algorithm"});
  EXPECT_THAT(fixed.out, HasSubstr("    Read only: true\n"));
  EXPECT_THAT(fixed.out, HasSubstr("    Additional constraints: must be one of dwa, edwa, eteb, "));
}

// Everything that a node tells can be given back to it: nothing changes, and nothing is refused.
TEST_F(Param, LoadTakesWhatDumpWrote) {
  for (const std::string node :
       {"/local_planner", "/world", "/collision_monitor", "/motor_control", "/navigator"}) {
    const Outcome dump = param({"dump", node});
    EXPECT_EQ(dump.status, 0) << dump.err;
    EXPECT_THAT(dump.out, StartsWith(node + ":\n  ros__parameters:\n"));
    EXPECT_THAT(dump.out, EndsWith("    use_sim_time: false\n"));
    const std::string file = (std::filesystem::temp_directory_path() / "param_dump.yaml").string();
    std::ofstream(file) << dump.out;
    const Outcome load = param({"load", node, file});
    EXPECT_EQ(load.status, 0) << load.err;
    EXPECT_THAT(load.out, HasSubstr("Set parameter use_sim_time successful\n"));
    EXPECT_EQ(param({"dump", node}).out, dump.out);
    std::filesystem::remove(file);
  }
}

TEST_F(Param, SaysWhoDoesNotAnswer) {
  const Outcome unknown = param({"get", "/local_planer", "algorithm"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("/local_planer"));
  const Outcome unset = param({"get", "/local_planner", "algorithmus"});
  EXPECT_EQ(unset.status, 1);
  EXPECT_EQ(unset.err, "/local_planner has no parameter algorithmus\n");
}

TEST_F(Param, OfAGraphFileAsBefore) {
  const std::string graph = std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml";
  const Outcome list = param({"list", graph, "local_planner", "--set", "local_planner.back_off_margin=0.2"});
  EXPECT_EQ(list.status, 0) << list.err;
  EXPECT_THAT(list.out, StartsWith("local_planner:\n  algorithm (string; one of dwa, "));
  EXPECT_THAT(list.out, HasSubstr("back_off_margin (double, m; 0 to 2; default 0.15, here 0.2)"));
  EXPECT_THAT(param({"dump", graph, "local_planner"}).out, HasSubstr("  back_off_margin: 0.15\n"));
  const Outcome missing = param({"list", "nowhere.yaml"});
  EXPECT_EQ(missing.status, 2);
  EXPECT_THAT(missing.err, HasSubstr("nowhere.yaml: no such file"));
  EXPECT_THAT(param({"list", "local_planner", "--set", "a.b=1"}).err, HasSubstr("is no graph file"));
}

}  // namespace
}  // namespace bw::test
