// navigate_to_pose and navigate_through_poses by clients of the actions, in lock-step. The robot drives at 1
// m/s as long as it is told to follow, and stands at once when it is not.
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <std_msgs/msg/empty.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"
#include "tests/components/navigator/navigator_world.hpp"
#include "tests/components/sent_goals.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ToPose = JazzyNav2::NavigateToPose;
using ThroughPoses = JazzyNav2::NavigateThroughPoses;
using Acts = std::vector<std::pair<double, std::function<void()>>>;

template <class Action = ToPose>
typename Action::Goal to(double x, const std::string& frame = "map") {
  typename Action::Goal message;
  message.pose(goal(x, frame));
  return message;
}

template <class Action>
typename Action::Goal through(const std::vector<double>& xs) {
  typename Action::Goal message;
  PosesStamped poses;
  for (const double x : xs) poses.push_back(goal(x));
  set_goal_poses(message, poses);
  return message;
}

/// Runs the navigator in the world with clients of its actions.
struct Drive {
  World world;
  SentGoals<ToPose> to_pose;
  SentGoals<ThroughPoses> through_poses;
  std::function<void(bw::Setup&)> more = [](bw::Setup&) {};

  void go(double seconds, Acts acts, const std::string& parameters = "") {
    run_with_script("ros_distro: jazzy\ncomponents: {navigator: {parameters: {" + parameters + "}}}", seconds,
                    [&](bw::Setup& setup) {
                      world.configure(setup);
                      to_pose.declare(setup, "navigate_to_pose");
                      through_poses.declare(setup, "navigate_through_poses");
                      more(setup);
                      at_times(setup, std::move(acts));
                    });
  }
};

// 3 m at 1 m/s: feedback each 0.2 s and at each change of the status; the tolerance of 0.2 m is entered and
// left standing at 3 s.
TEST(NavigateActions, APoseIsReachedWithFeedbackOnTheWay) {
  Drive drive;
  drive.go(8.0, {{1.0, [&] { drive.to_pose.send(to(3.0)); }}});
  const auto& sent = drive.to_pose.goals.at(0);
  EXPECT_TRUE(sent.accepted);
  EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_EQ(sent.result.error_code(), 0);
  EXPECT_EQ(sent.result.error_msg(), "");
  EXPECT_NEAR(sent.ended_at, 4.0, 0.15);
  EXPECT_NEAR(static_cast<double>(sent.feedback.size()), 3.0 / 0.2, 3.0);
  double last = 3.1;
  for (const auto& feedback : sent.feedback) {
    const double x = feedback.current_pose().pose().position().x();
    EXPECT_EQ(feedback.current_pose().header().frame_id(), "map");
    EXPECT_NEAR(feedback.distance_remaining(), 3.0 - x, 1e-5);
    EXPECT_LE(feedback.distance_remaining(), last);
    EXPECT_EQ(feedback.number_of_recoveries(), 0);
    last = feedback.distance_remaining();
  }
  EXPECT_LT(last, 0.35);
  const auto& half =
      sent.feedback[sent.feedback.size() / 2];  // at 1 m/s the seconds left are the metres left
  EXPECT_NEAR(half.estimated_time_remaining().sec() + 1e-9 * half.estimated_time_remaining().nanosec(),
              half.distance_remaining(), 1e-5);
  EXPECT_NEAR(half.navigation_time().sec() + 1e-9 * half.navigation_time().nanosec(),
              half.current_pose().pose().position().x(), 0.15);
}

// Each front end preempts the one before, and the robot drives on: the only request to stand is that of the
// arrival.
TEST(NavigateActions, EveryFrontEndPreemptsEveryOther) {
  Drive drive;
  Output<geometry_msgs::msg::PoseStamped> topic;
  drive.more = [&](bw::Setup& setup) { topic = setup.output<geometry_msgs::msg::PoseStamped>("goal_pose"); };
  drive.go(20.0,
           {{2.0, [&] { drive.to_pose.send(to(20.0)); }},  // after the graph's own goal
            {3.0,
             [&] {
               drive.through_poses.send(through<ThroughPoses>({10.0, 20.0}));
             }},
            {4.0, [&] { drive.to_pose.send(to(20.0)); }},
            {5.0, [&] { drive.to_pose.send(to(21.0)); }},
            {6.0, [&] { topic.publish(goal(8.0)); }}},
           "goal: {enabled: true, x: 30.0}");
  EXPECT_THAT(drive.to_pose.goals[0].result.error_msg(), "preempted by goal 3");
  EXPECT_THAT(drive.through_poses.goals[0].result.error_msg(), "preempted by goal 4");
  EXPECT_THAT(drive.to_pose.goals[1].result.error_msg(), "preempted by goal 5");
  EXPECT_THAT(drive.to_pose.goals[2].result.error_msg(), "preempted by goal 6");
  for (const auto& sent : drive.to_pose.goals) EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::aborted));
  EXPECT_THAT(drive.through_poses.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_NEAR(drive.to_pose.goals[2].ended_at, 6.0, 0.011);
  EXPECT_EQ(drive.world.statuses.back().status(), NavigationStatus_Constants::SUCCEEDED);
  EXPECT_NEAR(drive.world.x, 8.0, 1e-9);
  EXPECT_EQ(drive.world.stops, 1);
}

TEST(NavigateActions, CanceledTwiceItEndsOnceWhenTheRobotStands) {
  Drive drive;
  double x = 0.0;
  drive.go(6.0, {{1.0, [&] { drive.to_pose.send(to(30.0)); }},
                 {3.0,
                  [&] {
                    x = drive.world.x;
                    drive.to_pose.cancel(0);
                    drive.to_pose.cancel(0);
                  }},
                 {4.0, [&] { drive.to_pose.cancel(0); }}});
  const auto& sent = drive.to_pose.goals[0];
  EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::canceled));
  EXPECT_EQ(sent.result.error_msg(), "canceled by request");
  EXPECT_EQ(sent.result.error_code(), 0);
  EXPECT_NEAR(sent.ended_at, 3.1,
              0.06);  // it stands with the next odometry, which comes within 50 ms, and is looked at as late
  EXPECT_NEAR(drive.world.x, x, 0.051);
}

// Somebody cancels by the topic: the client did not ask for it, and its goal may not end canceled.
TEST(NavigateActions, WhatSomebodyElseCancelsEndsAborted) {
  Drive drive;
  Output<std_msgs::msg::Empty> topic;
  drive.more = [&](bw::Setup& setup) { topic = setup.output<std_msgs::msg::Empty>("cancel_goal"); };
  drive.go(4.0, {{1.0, [&] { drive.to_pose.send(to(30.0)); }}, {2.0, [&] { topic.publish({}); }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(drive.to_pose.goals[0].result.error_msg(), "canceled by request");
}

TEST(NavigateActions, OfFiftyGoalsAtOnceTheLastIsDriven) {
  Drive drive;
  drive.go(9.0, {{1.0, [&] {
                    for (int i = 0; i < 50; ++i) drive.to_pose.send(to(5.0));
                  }}});
  ASSERT_EQ(drive.to_pose.goals.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) {
    const auto& sent = drive.to_pose.goals[i];
    EXPECT_TRUE(sent.accepted);
    EXPECT_THAT(sent.ends, ElementsAre(i < 49 ? GoalStatus::aborted : GoalStatus::succeeded)) << i;
  }
  EXPECT_NEAR(drive.world.x, 5.0, 1e-9);
}

/// A goal that cannot be driven to, its code in Jazzy and from Kilted on, and a part of the sentence.
struct BadGoal {
  std::function<void(geometry_msgs::msg::PoseStamped&, std::string& behavior_tree)> spoil;
  std::uint16_t jazzy;
  std::uint16_t kilted;
  std::string sentence;
};

std::vector<BadGoal> bad_goals() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto in_odom_at = [](double seconds) {
    return [seconds](geometry_msgs::msg::PoseStamped& pose, std::string&) {
      pose.header(make_header("odom", LockstepRunner::kStart + Duration::seconds(seconds)));
    };
  };
  // tf2 refuses a pose of NaN and a quaternion of length 0, whatever the frame.
  return {{[](auto& pose, auto&) { pose.header().frame_id("mars"); }, 202, 9002, "frame 'mars'"},
          {[](auto& pose, auto&) { pose.header().frame_id(""); }, 202, 9002, "frame ''"},
          {[](auto& pose, auto&) { pose.pose().position().x(kNan); }, 202, 9002, "position is not finite"},
          {[](auto& pose, auto&) { pose.pose().orientation().w(0.0); }, 202, 9002, "length 0"},
          {[](auto&, auto& tree) { tree = "my_tree.xml"; }, 200, 9001, "'my_tree.xml'"},
          {in_odom_at(60.0), 202, 9002, "57.0 s ahead"},
          {in_odom_at(-30.0), 202, 9002, "33.0 s ago"}};
}

/// Where map and odom are one, for 1 s until now.
void publish_tf(bw::Setup& setup) {
  setup.every(Duration::milliseconds(100), "tf",
              [out = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) {
                tf2_msgs::msg::TFMessage message;
                message.transforms().push_back(to_transform("map", "odom", tick.now, {}));
                out.publish(message);
              });
}

// They come while a good goal is driven: that one is not disturbed.
template <class Action>
void expect_bad_goals_refused(const std::string& distro, std::uint16_t BadGoal::*code) {
  World world;
  SentGoals<Action> sent;
  run_with_script("ros_distro: " + distro + "\ncomponents: {navigator: {}}", 9.0, [&](bw::Setup& setup) {
    world.configure(setup);
    publish_tf(setup);
    sent.declare(setup, "navigate_to_pose");
    at_times(setup, {{1.0, [&] { sent.send(to<Action>(5.0)); }},
                     {3.0, [&] {
                        for (const BadGoal& bad : bad_goals()) {
                          auto message = to<Action>(1.0);
                          message.pose().pose().orientation().z(0.0);
                          bad.spoil(message.pose(), message.behavior_tree());
                          sent.send(message);
                        }
                      }}});
  });
  EXPECT_THAT(sent.goals[0].ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_EQ(world.stops, 1);
  const std::vector<BadGoal> bad = bad_goals();
  ASSERT_EQ(sent.goals.size(), bad.size() + 1);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    const auto& refused = sent.goals[i + 1];
    EXPECT_THAT(refused.ends, ElementsAre(GoalStatus::aborted)) << bad[i].sentence;
    EXPECT_EQ(error_code_of(refused.result), bad[i].*code) << bad[i].sentence;
    EXPECT_THAT(error_text_of(refused.result), HasSubstr(bad[i].sentence));
    EXPECT_NEAR(refused.ended_at, 3.0, 0.011) << "it is known at once";
  }
}

TEST(NavigateActions, BadGoalsAreRefusedWithJazzysCodes) {
  expect_bad_goals_refused<JazzyNav2::NavigateToPose>("jazzy", &BadGoal::jazzy);
}

TEST(NavigateActions, BadGoalsAreRefusedWithKiltedsCodes) {
  expect_bad_goals_refused<KiltedNav2::NavigateToPose>("kilted", &BadGoal::kilted);
}

// A stamp in map says nothing, as in tf2; in odom a stamp that is a little ahead of the newest transform is
// taken.
TEST(NavigateActions, AStampThatCanBeMetIsNoFault) {
  Drive drive;
  drive.more = publish_tf;
  auto in_map = to(2.0), in_odom = to(3.0, "odom");
  in_map.pose().header().stamp().sec(1);
  in_odom.pose().header().stamp(to_stamp(LockstepRunner::kStart + Duration::seconds(5.05)));
  drive.go(8.0, {{1.0, [&] { drive.to_pose.send(in_map); }}, {5.0, [&] { drive.to_pose.send(in_odom); }}});
  for (const auto& sent : drive.to_pose.goals) EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_NEAR(drive.world.x, 3.0, 1e-9);
}

// Three answers in a row, 2 s apart, that the goal is in a wall: 206 is Nav2's code of an occupied goal.
TEST(NavigateActions, AGoalInAWallEndsWithThePlannersReason) {
  Drive drive;
  drive.world.wall = 10.0;
  drive.go(9.0, {{1.0, [&] { drive.to_pose.send(to(11.0)); }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(drive.to_pose.goals[0].result.error_code(), 206);
  EXPECT_THAT(drive.to_pose.goals[0].result.error_msg(), HasSubstr("the goal lies in a wall"));
  EXPECT_EQ(drive.world.x, 0.0);
}

// The bumper touches something 2 s on the way and is released 30 s later: the status says so at once, the
// goal goes on afterwards.
TEST(NavigateActions, AGoalWaitsForABaseThatStands) {
  Drive drive;
  drive.world.base = base_state(BaseState_Constants::DRIVING);
  std::string told;
  drive.go(50.0,
           {{1.0, [&] { drive.to_pose.send(to(10.0)); }},
            {3.0, [&] { drive.world.base = base_state(BaseState_Constants::BUMPER, true, "bumper: left"); }},
            {3.2, [&] { told = drive.world.statuses.back().reason(); }},
            {33.0, [&] { drive.world.base = base_state(BaseState_Constants::WAITING); }}});
  EXPECT_EQ(told, "waiting: the base stands: bumper: left; until release_stop");
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_EQ(drive.to_pose.goals[0].feedback.back().number_of_recoveries(), 0);
  EXPECT_NEAR(drive.to_pose.goals[0].ended_at, 41.0, 0.3);  // 2 m before, 8 m after it, at 1 m/s
}

// By each way in a goal that comes meanwhile ends within a step (0.05 s), aborted, with the base's reason;
// 105 is what Nav2's controller would say of a robot that does not move.
TEST(NavigateActions, GoalsEndAtOnceWhileTheBaseStands) {
  const std::string kReason = "the base stands: the emergency stop is pressed by /panel; until release_stop";
  Drive drive;
  drive.world.base =
      base_state(BaseState_Constants::EMERGENCY_STOP, true, "the emergency stop is pressed by /panel");
  Output<geometry_msgs::msg::PoseStamped> topic;
  drive.more = [&](bw::Setup& setup) { topic = setup.output<geometry_msgs::msg::PoseStamped>("goal_pose"); };
  drive.go(6.0, {{1.0, [&] { drive.to_pose.send(to(10.0)); }},
                 {2.0,
                  [&] {
                    drive.through_poses.send(through<ThroughPoses>({3.0, 6.0}));
                  }},
                 {3.0, [&] { topic.publish(goal(10.0)); }},
                 {4.0, [&] { drive.world.base = base_state(BaseState_Constants::WAITING); }}});
  const auto& to_pose = drive.to_pose.goals[0];
  EXPECT_THAT(to_pose.ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(to_pose.result.error_msg(), kReason);
  EXPECT_EQ(to_pose.result.error_code(), 105);
  EXPECT_NEAR(to_pose.ended_at, 1.0, 0.051);
  EXPECT_EQ(drive.through_poses.goals[0].result.error_msg(), kReason);
  EXPECT_EQ(drive.through_poses.goals[0].result.error_code(), 105);
  const NavigationStatus& status = drive.world.statuses.back();
  EXPECT_EQ(status.status(), NavigationStatus_Constants::ABORTED);
  EXPECT_EQ(status.reason(), kReason);
  EXPECT_THAT(drive.world.log, ::testing::Contains(HasSubstr(kReason)));
  EXPECT_EQ(drive.world.x, 0.0) << "nor does anybody drive off when the stop is released";
}

// The goal of the graph is there already: it waits in hand, so that the base knows that it is interrupted,
// and takes a release.
TEST(NavigateActions, TheGraphsGoalWaitsForTheBase) {
  Drive drive;
  drive.world.base = base_state(BaseState_Constants::CHARGING, false, "the charger is connected");
  std::uint8_t mode = 0;
  drive.go(25.0,
           {{11.0, [&] { mode = drive.world.mode; }},
            {12.0, [&] { drive.world.base = base_state(BaseState_Constants::WAITING); }}},
           "goal: {enabled: true, x: 3.0}");
  EXPECT_EQ(mode, FollowRequest_Constants::FOLLOW);
  EXPECT_THAT(drive.world.log,
              ::testing::Contains("goal 1: waiting: the base stands: the charger is connected"));
  EXPECT_EQ(drive.world.statuses.back().status(), NavigationStatus_Constants::SUCCEEDED);
  EXPECT_NEAR(drive.world.x, 3.0, 1e-9);
}

// One that fell silent a second ago may have any state now: what it said last keeps no goal.
TEST(NavigateActions, ABaseThatFellSilentHindersNobody) {
  Drive drive;
  drive.world.base = base_state(BaseState_Constants::BUMPER, true, "bumper: left");
  drive.go(8.0, {{1.0, [&] { drive.world.base.reset(); }}, {2.2, [&] { drive.to_pose.send(to(3.0)); }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::succeeded));
}

TEST(NavigateActions, ARobotThatIsLostStopsAndItsGoalEnds) {
  Drive drive;
  drive.go(20.0, {{1.0, [&] { drive.to_pose.send(to(30.0)); }}, {3.0, [&] { drive.world.is_lost = true; }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(drive.to_pose.goals[0].result.error_code(), 202);
  EXPECT_THAT(drive.to_pose.goals[0].result.error_msg(), HasSubstr("does not know where it is"));
  EXPECT_EQ(drive.world.mode, FollowRequest_Constants::STOP);
}

TEST(NavigateActions, GoalsOfADeactivatedNavigatorEndAborted) {
  using lifecycle_msgs::srv::ChangeState;
  constexpr std::uint8_t kDeactivate = 4;
  Drive drive;
  Client<ChangeState> transition;
  drive.more = [&](bw::Setup& setup) { transition = setup.client<ChangeState>("navigator/change_state"); };
  drive.go(5.0, {{1.0, [&] { drive.to_pose.send(to(30.0)); }},
                 {2.0,
                  [&] {
                    ChangeState::Request request;
                    request.transition().id(kDeactivate);
                    transition.call(request, Duration::milliseconds(500),
                                    [](const ChangeState::Response*, const Tick&) {});
                  }},
                 {3.0, [&] { drive.to_pose.send(to(30.0)); }}});
  EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(drive.to_pose.goals[0].result.error_code(), 200);
  EXPECT_THAT(drive.to_pose.goals[0].result.error_msg(), HasSubstr("navigator"));
  EXPECT_EQ(drive.world.mode, FollowRequest_Constants::STOP);
  EXPECT_EQ(drive.to_pose.goals[1].acknowledged, 1);
  EXPECT_FALSE(drive.to_pose.goals[1].accepted);
}

// Poses at 3, 6 and 10 m: the first two are passed 0.7 m before them, without a stop.
TEST(NavigateActions, PosesAreDrivenThrough) {
  Drive drive;
  drive.go(14.0, {{1.0, [&] { drive.through_poses.send(through<ThroughPoses>({3.0, 6.0, 10.0})); }}});
  const auto& sent = drive.through_poses.goals[0];
  EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_EQ(drive.world.stops, 1);
  EXPECT_NEAR(sent.ended_at, 11.0, 0.15);
  for (const auto& feedback : sent.feedback) {
    const double x = feedback.current_pose().pose().position().x();
    const int remaining = x < 2.25               ? 3
                          : x > 2.35 && x < 5.25 ? 2
                          : x > 5.35             ? 1
                                                 : feedback.number_of_poses_remaining();
    EXPECT_EQ(feedback.number_of_poses_remaining(), remaining) << "at " << x;
  }
  EXPECT_EQ(drive.world.via_counts.front(), 2U);
  EXPECT_EQ(drive.world.via_counts.back(), 0U);
}

TEST(NavigateActions, ListsThatCannotBeDrivenThroughAreRefused) {
  Drive drive;
  auto mars = through<ThroughPoses>({1.0, 2.0, 3.0});
  mars.poses()[1].header().frame_id("mars");
  drive.go(3.0, {{1.0, [&] {
                    drive.through_poses.send({});
                    drive.through_poses.send(mars);
                    drive.through_poses.send(through<ThroughPoses>(std::vector<double>(1001, 1.0)));
                  }}});
  const auto& goals = drive.through_poses.goals;
  for (const auto& sent : goals) EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(goals[0].result.error_code(), 309);
  EXPECT_EQ(goals[0].result.error_msg(), "the list of poses is empty");
  EXPECT_EQ(goals[1].result.error_code(), 302);
  EXPECT_THAT(goals[1].result.error_msg(), HasSubstr("pose 1 of 3: the goal is in frame 'mars'"));
  EXPECT_EQ(goals[2].result.error_code(), 300);
  EXPECT_EQ(goals[2].result.error_msg(), "1001 poses to drive through are more than 1000");
  EXPECT_EQ(drive.world.x, 0.0);
}

// From Kilted on feedback and result say of each pose: pending 0, completed 1, failed 3.
TEST(NavigateActions, KiltedIsToldOfEachPose) {
  using Kilted = KiltedNav2::NavigateThroughPoses;
  World world;
  SentGoals<Kilted> sent;
  run_with_script("ros_distro: kilted\ncomponents: {navigator: {}}", 9.0, [&](bw::Setup& setup) {
    world.configure(setup);
    sent.declare(setup, "navigate_through_poses");
    at_times(setup, {{1.0,
                      [&] {
                        sent.send(through<Kilted>({2.0, 30.0}));
                      }},
                     {5.0, [&] { sent.cancel(0); }}});
  });
  const auto statuses = [](const auto& message) {
    std::vector<int> list;
    for (const auto& waypoint : message.waypoint_statuses()) list.push_back(waypoint.waypoint_status());
    return list;
  };
  EXPECT_THAT(statuses(sent.goals[0].feedback.front()), ElementsAre(0, 0));
  EXPECT_THAT(statuses(sent.goals[0].feedback.back()), ElementsAre(1, 0));
  EXPECT_THAT(statuses(sent.goals[0].result), ElementsAre(1, 3));
  EXPECT_THAT(sent.goals[0].ends, ElementsAre(GoalStatus::canceled));
}

TEST(NavigateActions, HumblesClientsAreServed) {
  using Humble = HumbleNav2::NavigateToPose;
  World world;
  SentGoals<Humble> sent;
  run_with_script("ros_distro: humble\ncomponents: {navigator: {}}", 6.0, [&](bw::Setup& setup) {
    world.configure(setup);
    sent.declare(setup, "navigate_to_pose");
    at_times(setup, {{1.0, [&] { sent.send(to<Humble>(2.0)); }}});
  });
  EXPECT_THAT(sent.goals[0].ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_GT(sent.goals[0].feedback.size(), 8U);
}

}  // namespace
}  // namespace bw
