// `bandwagon lifecycle` on the nodes of a running graph, in the words of `ros2 lifecycle`.
#include <memory>

#include <gmock/gmock.h>

#include "tests/interop/running_graph.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

class LifecycleVerb : public testing::Test {
 protected:
  static void SetUpTestSuite() { graph_ = std::make_unique<RunningGraph>(); }
  static void TearDownTestSuite() {
    EXPECT_EQ(graph_->stop(), 0) << graph_->process().err();
    graph_.reset();
  }
  static Outcome lifecycle(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {BANDWAGON_PROGRAM, "lifecycle"});
    return run_to_end(arguments, std::chrono::seconds(60));
  }

  static std::unique_ptr<RunningGraph> graph_;
};

std::unique_ptr<RunningGraph> LifecycleVerb::graph_;

TEST_F(LifecycleVerb, NamesManagedNodesAndTheirStates) {
  EXPECT_EQ(lifecycle({"nodes"}).out, "/map_server\n/motor_control\n/robot_base\n/world\n");
  EXPECT_EQ(
      lifecycle({"get"}).out,
      "/map_server: active [3]\n/motor_control: active [3]\n/robot_base: active [3]\n/world: active [3]\n");
  EXPECT_EQ(lifecycle({"get", "map_server"}).out, "active [3]\n");
}

TEST_F(LifecycleVerb, ListsWhatMayBeAskedForNow) {
  EXPECT_EQ(
      lifecycle({"list", "/world"}).out,
      "- deactivate [4]\n\tStart: active\n\tGoal: deactivating\n- shutdown [7]\n\tStart: active\n\tGoal: shuttingdown\n");
  EXPECT_THAT(lifecycle({"list", "/world", "-a"}).out,
              HasSubstr("- transition_error [62]\n\tStart: errorprocessing\n\tGoal: finalized\n"));
}

TEST_F(LifecycleVerb, SetsByNameAndByNumberAndSaysWhyNot) {
  const Outcome down = lifecycle({"set", "/map_server", "deactivate"});
  EXPECT_EQ(down.status, 0) << down.err;
  EXPECT_EQ(down.out, "Transitioning successful\n");
  EXPECT_EQ(lifecycle({"get", "/map_server"}).out, "inactive [2]\n");
  const Outcome again = lifecycle({"set", "/map_server", "deactivate"});
  EXPECT_EQ(again.status, 2);
  EXPECT_THAT(again.err,
              HasSubstr("/map_server has no transition deactivate now; it has: cleanup, activate, shutdown"));
  EXPECT_EQ(lifecycle({"set", "/map_server", "3"}).status, 0);
  EXPECT_EQ(lifecycle({"get", "/map_server"}).out, "active [3]\n");
  const Outcome unknown = lifecycle({"get", "/mapserver"});
  EXPECT_EQ(unknown.status, 2);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean '/map_server'?"));
}

}  // namespace
}  // namespace bw::test
