// The whole hallway without people, in lock-step: paths that come back over themselves by follow_path, and
// poses on one line by navigate_through_poses. The robot's true position is compared, which it knows by about
// 0.1 m.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav2_msgs/action/follow_path.hpp>
#include <nav2_msgs/msg/collision_monitor_state.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "tests/components/local_planner/random_path.hpp"
#include "tests/components/sent_goals.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using FollowPath = nav2_msgs::action::FollowPath;
using ThroughPoses = JazzyNav2::NavigateThroughPoses;

constexpr double kBelief = 0.1;  // [m] by which the robot errs

/// Runs the hallway without people from (3, 0), and watches the truth ten times a second or more.
template <class Action>
struct Hallway {
  SentGoals<Action> goals;
  std::vector<Pose2> truth;
  int crept = 0;  ///< commands that were limited because something is not seen

  void go(const std::string& action, const typename Action::Goal& goal, double seconds) {
    Graph graph = load_graph(std::string(BANDWAGON_SOURCE_DIR) + "/config/graphs/hallway.yaml",
                             {"navigator.goal.enabled=false", "world.start.x=3.0", "world.people.scripted=[]",
                              "world.people.social.walkers=[]"});
    std::vector<ExtraComponent> extra;
    extra.push_back({"script", std::make_unique<Script>([&](Setup& setup) {
                       goals.declare(setup, action);
                       setup.input<bandwagon_msgs::msg::GroundTruth>(
                           "sim/ground_truth", Qos::standard(),
                           [this](const auto& m, const Tick&) { truth.push_back(from_pose(m.pose())); });
                       setup.input<nav2_msgs::msg::CollisionMonitorState>(
                           "collision_monitor_state", Qos::standard(),
                           [this](const auto& m, const Tick&) { crept += m.polygon_name() == "sight"; });
                       at_times(setup, {{3.0, [this, goal] { goals.send(goal); }}});
                     })});
    Host host(std::move(graph), {.clock = ClockMode::lockstep}, std::move(extra));
    const RunEnd end = host.run(Duration::seconds(seconds));
    EXPECT_FALSE(end.has_thrown) << end.reason;
  }
};

// From where the robot stands d metres out and back over the same line to 1 m behind. At 1 m/s it takes 2 d +
// 1 s, and 5 s of rotating, speeding up and braking; the test waits for twice that.
TEST(FoldedPaths, AreDrivenOutAndBackByFollowPath) {
  for (double d = 1.0; d <= 6.0; d += 1.0) {
    FollowPath::Goal goal;
    goal.path(to_path("map", Time{}, path_over({{3, 0}, {3 + d, 0}, {2, 0}})));
    Hallway<FollowPath> hallway;
    hallway.go("follow_path", goal, 3.0 + 2.0 * (2.0 * d + 1.0 + 5.0));
    const auto& sent = hallway.goals.goals.at(0);
    EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::succeeded)) << d << ": " << sent.result.error_msg();
    double farthest = 0.0;
    for (const Pose2& X : hallway.truth) farthest = std::max(farthest, X.x);
    EXPECT_GE(farthest, 3.0 + d - 0.25 - kBelief) << d;
    EXPECT_LE(farthest, 3.0 + d + 0.25 + kBelief) << d;
    EXPECT_LT((hallway.truth.back().position() - Vector2(2, 0)).norm(), 0.25 + kBelief) << d;
    EXPECT_EQ(hallway.crept, 0) << d << ": odometry turns the walls' ends, and nothing is covered";
    std::cout << "d " << d << ": farthest " << farthest - 3.0 << " m, " << sent.ended_at - 3.0 << " s\n";
  }
}

// 3 m out, 5 m back: 8 s at 1 m/s and 5 s more; twice that. Each pose is passed within kViaRadius, 0.7 m, in
// its turn.
TEST(FoldedPaths, PosesOnOneLineArePassedInTheirOrder) {
  const std::vector<Vector2> positions = {{6, 0}, {3, 0}, {1, 0}};
  ThroughPoses::Goal goal;
  PosesStamped poses;
  for (const Vector2& position : positions) {
    geometry_msgs::msg::PoseStamped pose;
    pose.header(make_header("map", Time{}));
    pose.pose(to_pose(Pose2{position.x(), position.y(), std::numbers::pi}));
    poses.push_back(pose);
  }
  set_goal_poses(goal, poses);
  Hallway<ThroughPoses> hallway;
  hallway.go("navigate_through_poses", goal, 3.0 + 26.0);
  const auto& sent = hallway.goals.goals.at(0);
  EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::succeeded)) << sent.result.error_msg();
  EXPECT_EQ(passed_in_order(positions, hallway.truth, 0.7 + kBelief), 3U);
  std::cout << "through poses: " << sent.ended_at - 3.0 << " s\n";
}

}  // namespace
}  // namespace bw
