// What cannot be driven to has one of Nav2's codes, the same by each way in: the path actions, the navigate
// actions, a list, and the topic, whose status says the sentence. The real planner behind the navigator, on
// the map of planner_rig.hpp.
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>

#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "tests/components/global_planner/planner_rig.hpp"
#include "tests/components/sent_goals.hpp"

namespace bw {
namespace {

namespace alone = nav2_msgs::action::ComputePathToPose_Result_Constants;
namespace through = nav2_msgs::action::ComputePathThroughPoses_Result_Constants;
namespace waypoints = nav2_msgs::action::FollowWaypoints_Result_Constants;
using bandwagon_msgs::msg::NavigationStatus;
using geometry_msgs::msg::PoseStamped;

/// A goal that cannot be driven to, and the codes of a path to it, alone and through poses.
struct Case {
  PoseStamped goal;
  std::uint16_t alone;
  std::uint16_t among_poses;
  PlannerWorld world{};
  bool is_a_pose = true;  ///< false: a list that holds it is not taken up at all
};

PoseStamped pose(double x, double y, const std::string& frame = "map") {
  PoseStamped stamped;
  stamped.header().frame_id(frame);
  stamped.pose(to_pose({x, y, 0.0}));
  return stamped;
}

PoseStamped without_rotation() {
  PoseStamped stamped = pose(2.0, 3.0);
  stamped.pose().orientation().w(0.0);
  return stamped;
}

/// The robot at (x, y) of the map: odom is rotated by a right angle at (1, 3).
PlannerWorld with_robot_at(double x, double y) {
  return {.X_OB = inverse(kX_MO) * Pose2{x, y, std::numbers::pi / 2.0}};
}

std::vector<Case> cases() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  return {{pose(11.0, 3.0), alone::GOAL_OUTSIDE_MAP, through::GOAL_OUTSIDE_MAP},
          {pose(5.05, 3.0), alone::GOAL_OCCUPIED, through::GOAL_OCCUPIED},
          {pose(9.0, 3.0), alone::NO_VALID_PATH, through::NO_VALID_PATH},
          {pose(4.0, 3.0), alone::START_OUTSIDE_MAP, through::START_OUTSIDE_MAP, with_robot_at(-2.0, 3.0)},
          {pose(7.0, 3.0), alone::START_OCCUPIED, through::START_OCCUPIED, with_robot_at(9.0, 5.0)},
          {pose(4.0, 3.0), alone::TIMEOUT, through::TIMEOUT, {.has_map = false}},
          {pose(4.0, 3.0, "mars"), alone::TF_ERROR, through::TF_ERROR, {}, false},
          {pose(kNan, 3.0), alone::TF_ERROR, through::TF_ERROR, {}, false},
          {without_rotation(), alone::TF_ERROR, through::TF_ERROR, {}, false}};
}

/// Every way in, one after the other. No recovery, no second try: what the planner says first ends the goal.
struct Interfaces {
  SentGoals<JazzyNav2::ComputePathToPose> path;
  SentGoals<JazzyNav2::ComputePathThroughPoses> path_through;
  SentGoals<JazzyNav2::NavigateToPose> navigate;
  SentGoals<JazzyNav2::NavigateThroughPoses> navigate_through;
  SentGoals<JazzyNav2::FollowWaypoints> list;
  Output<PoseStamped> topic;
  NavigationStatus status;

  void go(const Case& one) {
    PlannerWorld world = one.world;
    world.seconds = 8.0;
    world.more = "  navigator: {parameters: {max_recoveries: 0, max_plan_failures: 1}}\n";
    run_planner(world, [&](bw::Setup& setup) {
      declare(setup);
      stand(setup, kX_MO * world.X_OB);
      at_times(setup, acts(one.goal));
    });
  }

 private:
  void declare(bw::Setup& setup) {
    path.declare(setup, "compute_path_to_pose");
    path_through.declare(setup, "compute_path_through_poses");
    navigate.declare(setup, "navigate_to_pose");
    navigate_through.declare(setup, "navigate_through_poses");
    list.declare(setup, "follow_waypoints");
    topic = setup.output<PoseStamped>("goal_pose");
    setup.input<NavigationStatus>("navigation_status", Qos::standard(50),
                                  [this](const auto& message, const Tick&) { status = message; });
  }

  /// A robot that stands at X_MB, and a local planner that nobody needs.
  static void stand(bw::Setup& setup, const Pose2& X_MB) {
    setup.output<bandwagon_msgs::msg::FollowStatus>("follow_status");
    setup.every(Duration::milliseconds(50), "stand",
                [X_MB, out = setup.output<nav_msgs::msg::Odometry>("odometry/filtered")](const Tick&) {
                  nav_msgs::msg::Odometry message;
                  message.pose().pose(to_pose(X_MB));
                  out.publish(message);
                });
  }

  std::vector<std::pair<double, std::function<void()>>> acts(const PoseStamped& goal) {
    return {
        {1.0, [this, goal] { send(path, goal); }},     {1.5, [this, goal] { send(path_through, goal); }},
        {2.0, [this, goal] { send(navigate, goal); }}, {3.0, [this, goal] { send(navigate_through, goal); }},
        {4.0, [this, goal] { send(list, goal); }},     {6.0, [this, goal] { topic.publish(goal); }}};
  }

  template <class Action>
  static void send(SentGoals<Action>& goals, const PoseStamped& where) {
    typename Action::Goal goal;
    if constexpr (requires { goal.goal(where); }) {
      goal.goal(where);
    } else if constexpr (requires { goal.pose(where); }) {
      goal.pose(where);
    } else {
      set_goal_poses(goal, {where});
    }
    goals.send(goal);
  }
};

TEST(ErrorCodes, AreNav2sByEachWayIn) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.alone);
    Interfaces interfaces;
    interfaces.go(one);
    EXPECT_EQ(interfaces.path.goals[0].result.error_code(), one.alone);
    EXPECT_EQ(interfaces.path_through.goals[0].result.error_code(), one.among_poses);
    EXPECT_EQ(interfaces.navigate.goals[0].result.error_code(), one.alone);
    EXPECT_EQ(interfaces.navigate_through.goals[0].result.error_code(), one.among_poses);
    const auto& list = interfaces.list.goals[0].result;
    if (one.is_a_pose) {
      ASSERT_EQ(list.missed_waypoints().size(), 1U);
      EXPECT_EQ(list.missed_waypoints()[0].error_code(), one.alone);
    } else {
      EXPECT_EQ(list.error_code(), waypoints::UNKNOWN);
    }
    // The topic has no result: its status says the sentence.
    EXPECT_EQ(interfaces.status.reason(), interfaces.navigate.goals[0].result.error_msg());
    EXPECT_EQ(interfaces.status.status(), bandwagon_msgs::msg::NavigationStatus_Constants::ABORTED);
  }
}

}  // namespace
}  // namespace bw
