// Our navigator above foreign servers, in lock-step: planner_server, controller_server and behavior_server
// are made of the runtime's action servers in a script, and behave as Nav2's do. The robot drives along x at
// 1 m/s, or back at 0.1 m/s.
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"
#include "tests/components/sent_goals.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Acts = std::vector<std::pair<double, std::function<void()>>>;

/// Servers of Nav2 in one layout, and the robot they drive.
template <class Nav2>
struct Servers {
  using ComputePath = typename Nav2::ComputePathToPose;
  using ComputePaths = typename Nav2::ComputePathThroughPoses;
  using FollowPath = typename Nav2::FollowPath;
  using BackUp = typename Nav2::BackUp;
  using Clear = typename Nav2::ClearEntireCostmap;

  double x = 0.0;
  double goal_x = 0.0;
  std::uint16_t plan_code = 0;    ///< of a planner that fails
  std::uint16_t follow_code = 0;  ///< of a controller that gives up at once
  bool is_stuck = false;          ///< the robot does not move forward
  bool has_behaviors = true;
  std::vector<std::size_t> planned_poses;
  std::string planner_id, controller_id;
  int paths = 0, back_ups = 0, local_clears = 0, global_clears = 0;
  GoalHandle<FollowPath> following;
  GoalHandle<BackUp> backing;
  double backed_from = 0.0;
  bool is_following = false, is_backing = false;  ///< at the last look: handles do not outlive the run

  void configure(bw::Setup& setup) {
    offer_planner(setup);
    setup.action<FollowPath>("follow_path",
                             {.on_goal = [this](const auto& goal, const Tick&) { follow(goal); },
                              .on_cancel =
                                  [this](const auto& goal, const Tick&) {
                                    if (goal == following) goal.canceled({});
                                  },
                              .abandoned = [](const std::string&) { return typename FollowPath::Result(); }});
    if (has_behaviors)
      setup.action<BackUp>("backup",
                           {.on_goal =
                                [this](const auto& goal, const Tick&) {
                                  EXPECT_FALSE(following.is_open()) << "two drive at once";
                                  goal.execute();
                                  backing = goal;
                                  backed_from = x;
                                  ++back_ups;
                                },
                            .on_cancel = [](const auto& goal, const Tick&) { goal.canceled({}); },
                            .abandoned = [](const std::string&) { return typename BackUp::Result(); }});
    setup.service<Clear>("local_costmap/clear_entirely_local_costmap",
                         [this](const auto&, const Tick&) { return count(local_clears); });
    setup.service<Clear>("global_costmap/clear_entirely_global_costmap",
                         [this](const auto&, const Tick&) { return count(global_clears); });
    setup.every(Duration::milliseconds(50), "drive",
                [this, odom = setup.output<nav_msgs::msg::Odometry>("odom"),
                 tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) {
                  drive(odom, tf, tick);
                });
  }

  typename Clear::Response count(int& clears) {
    ++clears;
    return {};
  }

  void offer_planner(bw::Setup& setup) {
    const auto answer = [this](const auto& handle, const PosesStamped& poses, auto result) {
      planned_poses.push_back(poses.size());
      planner_id = handle.goal().planner_id();
      if (plan_code != 0) {
        set_error(result, plan_code, "no way there");
        return handle.abort(result);
      }
      result.path(to_path("map", LockstepRunner::kStart, {{x, 0, 0}, from_pose(poses.back().pose())}));
      handle.succeed(result);
    };
    setup.action<ComputePath>(
        "compute_path_to_pose",
        {.on_goal =
             [answer](const auto& handle, const Tick&) {
               answer(handle, {handle.goal().goal()}, typename ComputePath::Result());
             },
         .on_cancel = nullptr,
         .abandoned = [](const std::string&) { return typename ComputePath::Result(); }});
    setup.action<ComputePaths>(
        "compute_path_through_poses",
        {.on_goal =
             [answer](const auto& handle, const Tick&) {
               answer(handle, goal_poses(handle.goal()), typename ComputePaths::Result());
             },
         .on_cancel = nullptr,
         .abandoned = [](const std::string&) { return typename ComputePaths::Result(); }});
  }

  void follow(const GoalHandle<FollowPath>& handle) {
    EXPECT_FALSE(backing.is_open()) << "two drive at once";
    ++paths;
    controller_id = handle.goal().controller_id();
    goal_x = handle.goal().path().poses().back().pose().position().x();
    if (following.is_open()) following.abort({});  // as Nav2's server does with a goal that is preempted
    following = handle;
    handle.execute();
    if (follow_code == 0) return;
    typename FollowPath::Result result;
    set_error(result, follow_code, "no valid trajectory");
    handle.abort(result);
  }

  void drive(const Output<nav_msgs::msg::Odometry>& odom, const Output<tf2_msgs::msg::TFMessage>& tf,
             const Tick& tick) {
    double v = 0.0;
    if (following.is_open() && !is_stuck) v = std::copysign(1.0, goal_x - x);
    if (backing.is_open()) v = -0.1;
    x += 0.05 * v;
    if (following.is_open() && std::abs(goal_x - x) < 0.05) {
      x = goal_x;
      following.succeed({});
    }
    if (backing.is_open() && backed_from - x > 0.299) backing.succeed({});
    is_following = following.is_open();
    is_backing = backing.is_open();
    nav_msgs::msg::Odometry message;
    message.twist().twist().linear().x(v);
    odom.publish(message);
    tf2_msgs::msg::TFMessage frames;
    frames.transforms().push_back(to_transform("map", "odom", tick.now, {1.0, 0.0, 0.0}));
    frames.transforms().push_back(to_transform("odom", "base_link", tick.now, {x - 1.0, 0.0, 0.0}));
    tf.publish(frames);
  }
};

constexpr const char* kGraph = R"(
components:
  bt_navigator: {type: navigator, parameters: {pose_source: tf, follow_waypoints: false}}
  nav2_servers: {parameters: {planner_id: GridBased, controller_id: FollowPath}}
)";

template <class Nav2>
struct Drive {
  Servers<Nav2> servers;
  SentGoals<typename Nav2::NavigateToPose> to_pose;
  SentGoals<typename Nav2::NavigateThroughPoses> through_poses;

  void go(const std::string& distro, double seconds, Acts acts, bool has_servers = true) {
    run_with_script("ros_distro: " + distro + kGraph, seconds, [&](bw::Setup& setup) {
      if (has_servers) {
        servers.configure(setup);
      } else {
        setup.every(Duration::milliseconds(50), "drive",
                    [this, odom = setup.output<nav_msgs::msg::Odometry>("odom"),
                     tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) {
                      servers.drive(odom, tf, tick);
                    });
      }
      to_pose.declare(setup, "navigate_to_pose");
      through_poses.declare(setup, "navigate_through_poses");
      at_times(setup, std::move(acts));
    });
  }
  void send(double x) {
    typename Nav2::NavigateToPose::Goal goal;
    goal.pose().header().frame_id("map");
    goal.pose().pose(to_pose_message(x));
    to_pose.send(goal);
  }
  static geometry_msgs::msg::Pose to_pose_message(double x) { return bw::to_pose({x, 0, 0}); }
};

// 5 m at 1 m/s: a path at once and one each second, each of which preempts the one before.
template <class Nav2>
void expect_reached(const std::string& distro) {
  Drive<Nav2> drive;
  drive.go(distro, 12.0, {{1.0, [&] { drive.send(5.0); }}});
  const auto& sent = drive.to_pose.goals[0];
  EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_EQ(error_code_of(sent.result), 0);
  EXPECT_NEAR(drive.servers.x, 5.0, 0.21);
  EXPECT_NEAR(sent.ended_at, 6.0, 0.5);
  EXPECT_EQ(drive.servers.planner_id, "GridBased");
  EXPECT_EQ(drive.servers.controller_id, "FollowPath");
  EXPECT_NEAR(drive.servers.paths, 5, 1);
  EXPECT_EQ(drive.servers.back_ups, 0);
  EXPECT_EQ(drive.servers.local_clears, 0);
  EXPECT_FALSE(drive.servers.is_following);
}

TEST(Nav2Servers, AGoalIsReachedWithHumble) { expect_reached<HumbleNav2>("humble"); }
TEST(Nav2Servers, AGoalIsReachedWithJazzy) { expect_reached<JazzyNav2>("jazzy"); }

TEST(Nav2Servers, PosesArePlannedThrough) {
  Drive<JazzyNav2> drive;
  drive.go("jazzy", 14.0, {{1.0, [&] {
                              JazzyNav2::NavigateThroughPoses::Goal goal;
                              for (const double x : {3.0, 8.0}) {
                                auto& pose = goal.poses().emplace_back();
                                pose.header().frame_id("map");
                                pose.pose(to_pose({x, 0, 0}));
                              }
                              drive.through_poses.send(goal);
                            }}});
  EXPECT_THAT(drive.through_poses.goals[0].ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_EQ(drive.servers.planned_poses.front(), 2U);
  EXPECT_EQ(drive.servers.planned_poses.back(), 1U);
}

// The controller is given the newer path while it drives: the robot never stands between.
TEST(Nav2Servers, ANewerGoalPreemptsWithoutAStop) {
  Drive<JazzyNav2> drive;
  std::vector<double> positions;
  drive.go("jazzy", 12.0,
           {{1.0, [&] { drive.send(20.0); }},
            {3.0,
             [&] {
               positions.push_back(drive.servers.x);
               drive.send(8.0);
             }},
            {4.0, [&] { positions.push_back(drive.servers.x); }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(drive.to_pose.goals[0].result.error_msg(), "preempted by goal 2");
  EXPECT_THAT(drive.to_pose.goals[1].ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_NEAR(positions[1] - positions[0], 1.0, 0.051);
}

TEST(Nav2Servers, ACanceledGoalCancelsTheControllers) {
  Drive<JazzyNav2> drive;
  drive.go("jazzy", 6.0, {{1.0, [&] { drive.send(20.0); }}, {3.0, [&] { drive.to_pose.cancel(0); }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::canceled));
  EXPECT_FALSE(drive.servers.is_following);
  EXPECT_NEAR(drive.servers.x, 2.0, 0.11);
  EXPECT_NEAR(drive.to_pose.goals[0].ended_at, 3.1, 0.1);
}

// Jazzy hands on the code of the server that failed. The default tree clears the global costmap and tries
// again; so does this.
TEST(Nav2Servers, AGoalWithoutAPathEndsWithThePlannersCode) {
  for (const int code : {201, 204, 206, 208}) {
    Drive<JazzyNav2> drive;
    drive.servers.plan_code = static_cast<std::uint16_t>(code);
    drive.go("jazzy", 20.0, {{1.0, [&] { drive.send(5.0); }}});
    const auto& sent = drive.to_pose.goals[0];
    EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::aborted));
    EXPECT_EQ(sent.result.error_code(), code);
    EXPECT_EQ(sent.result.error_msg(), "no plan: planner_server: no way there");
    EXPECT_EQ(drive.servers.global_clears, code == 201 ? 1 : 3)
        << "no planner of that name will come; the rest is tried thrice";
    EXPECT_EQ(drive.servers.x, 0.0);
  }
}

// It gives up at once, for good: after six recoveries, every second one driving back by 0.3 m, the goal ends
// with its code.
TEST(Nav2Servers, AControllerThatGivesUpIsRecoveredFromAndTold) {
  Drive<JazzyNav2> drive;
  drive.servers.follow_code = 106;
  drive.go("jazzy", 60.0, {{1.0, [&] { drive.send(5.0); }}});
  const auto& sent = drive.to_pose.goals[0];
  EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(sent.result.error_code(), 106);
  EXPECT_THAT(sent.result.error_msg(), HasSubstr("controller_server: no valid trajectory"));
  EXPECT_EQ(drive.servers.back_ups, 3);
  EXPECT_NEAR(drive.servers.x, -0.9, 0.05);
  EXPECT_GE(drive.servers.local_clears, 7);
  EXPECT_FALSE(drive.servers.is_backing);
}

// Stuck for 15 s: the robot makes no progress, waits, drives back, and goes on when it can.
TEST(Nav2Servers, AStuckRobotGoesOnWhenItCan) {
  Drive<JazzyNav2> drive;
  drive.go("jazzy", 60.0,
           {{1.0, [&] { drive.send(5.0); }},
            {2.0, [&] { drive.servers.is_stuck = true; }},
            {27.0, [&] { drive.servers.is_stuck = false; }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_EQ(drive.servers.back_ups, 1);
  EXPECT_GE(drive.to_pose.goals[0].feedback.back().number_of_recoveries(), 2);
}

TEST(Nav2Servers, WithoutABehaviorServerItOnlyWaits) {
  Drive<JazzyNav2> drive;
  drive.servers.has_behaviors = false;
  drive.servers.follow_code = 106;
  drive.go("jazzy", 60.0, {{1.0, [&] { drive.send(5.0); }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(drive.servers.x, 0.0);
}

TEST(Nav2Servers, WithoutServersTheGoalEndsWithThatReason) {
  Drive<JazzyNav2> drive;
  drive.go("jazzy", 40.0, {{1.0, [&] { drive.send(5.0); }}}, false);
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_THAT(drive.to_pose.goals[0].result.error_msg(), HasSubstr("there is no planner_server"));
}

}  // namespace
}  // namespace bw
