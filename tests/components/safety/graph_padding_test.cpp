// What the graphs of robots that may graze nothing ask of the collision monitor.
#include <gtest/gtest.h>

#include "components/safety/collision_monitor.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "tests/components/safety/sweeps.hpp"

namespace bw::safety {
namespace {

class GraphPadding : public testing::TestWithParam<const char*> {};

/// Allowed speed of a Kobuki that is told to drive straight on at 0.6 m/s and passes a pillar `gap` [m] beside its rim.
double speed_past(double gap, const CollisionMonitorOptions& options) {
  Robot robot;
  robot.radius = 0.18;
  CollisionMonitor monitor(robot, options);
  const Sweep sweep = sweep_of({{{0.1, 0.18 + gap + 0.5}, 0.5}});
  const Time now = Time::seconds(10.0);
  monitor.odometry(now, {}, {0.04, 0.0});
  Sweep seen = sweep;
  seen.time = now;
  monitor.sweep(now, seen.view());
  return monitor.judge(now, {0.6, 0.0}).allowed.v;
}

// In a gap of 0.41 m a Kobuki (radius 0.18 m, bumpers pressed 0.01 m before the rim) that passed with 0.02 m to the side
// at 0.63 m/s pressed a bumper 0.1 s later: warehouse 1 of bench explore. Its distance to the left wall was 0.017 m when
// the monitor stopped it. 0.05 m/s is graze_speed.
TEST_P(GraphPadding, PastWhatIsNearerThanThreeCentimetresTheRobotCreeps) {
  const Graph graph = load_graph(std::string(BANDWAGON_SOURCE_DIR) + GetParam());
  const ComponentNode* node = graph.find("collision_monitor");
  ASSERT_NE(node, nullptr);
  const auto options = read_parameters<CollisionMonitorOptions>(node->parameters, "collision_monitor");
  EXPECT_DOUBLE_EQ(speed_past(0.02, options), 0.05);
  EXPECT_DOUBLE_EQ(speed_past(0.04, options), 0.6);
}

INSTANTIATE_TEST_SUITE_P(Graphs, GraphPadding,
                         testing::Values("/config/graphs/map_drive.yaml", "/config/graphs/robot.yaml"));

}  // namespace
}  // namespace bw::safety
