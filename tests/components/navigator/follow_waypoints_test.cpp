// follow_waypoints by clients of the action, in lock-step. The robot drives at 1 m/s; goals beyond the wall
// cannot be reached.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_msgs/msg/empty.hpp>

#include "components/messages/nav2_layouts.hpp"
#include "tests/components/navigator/navigator_world.hpp"
#include "tests/components/sent_goals.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using Waypoints = JazzyNav2::FollowWaypoints;
using ToPose = JazzyNav2::NavigateToPose;
using Acts = std::vector<std::pair<double, std::function<void()>>>;

template <class Action = Waypoints>
typename Action::Goal over(const std::vector<double>& xs) {
  typename Action::Goal message;
  for (const double x : xs) message.poses().push_back(goal(x));
  return message;
}

ToPose::Goal to_pose_goal(double x) {
  ToPose::Goal message;
  message.pose(goal(x));
  return message;
}

struct WaypointDrive {
  World world;
  SentGoals<Waypoints> waypoints;
  SentGoals<ToPose> to_pose;
  Output<std_msgs::msg::Empty> cancel_goal;

  void go(double seconds, Acts acts, const std::string& parameters = "") {
    run_with_script("ros_distro: jazzy\ncomponents: {navigator: {parameters: {" + parameters + "}}}", seconds,
                    [&](bw::Setup& setup) {
                      world.configure(setup);
                      waypoints.declare(setup, "follow_waypoints");
                      to_pose.declare(setup, "navigate_to_pose");
                      cancel_goal = setup.output<std_msgs::msg::Empty>("cancel_goal");
                      at_times(setup, std::move(acts));
                    });
  }
};

/// The waypoints that feedback told of, each once in a row.
template <class Goal>
std::vector<std::uint32_t> visited(const Goal& sent) {
  std::vector<std::uint32_t> list;
  for (const auto& feedback : sent.feedback) {
    if (list.empty() || list.back() != feedback.current_waypoint())
      list.push_back(feedback.current_waypoint());
  }
  return list;
}

// 2 m, 1 m and 2 m at 1 m/s with a pause of 1 s after each but the last: 7 s, and a stop at each.
TEST(FollowWaypoints, EachIsStoppedAt) {
  WaypointDrive drive;
  drive.go(12.0, {{1.0, [&] { drive.waypoints.send(over({2.0, 3.0, 1.0})); }}});
  const auto& sent = drive.waypoints.goals[0];
  EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_THAT(sent.result.missed_waypoints(), IsEmpty());
  EXPECT_EQ(sent.result.error_code(), 0);
  EXPECT_NEAR(sent.ended_at, 8.0, 0.5);
  EXPECT_THAT(visited(sent), ElementsAre(0, 1, 2));
  EXPECT_NEAR(static_cast<double>(sent.feedback.size()), 7.0 / 0.2, 7.0);
  EXPECT_EQ(drive.world.stops, 3);
  EXPECT_NEAR(drive.world.x, 1.0, 1e-9);
}

// It begins with the third of three and drives all of them twice more.
TEST(FollowWaypoints, FirstIndexAndLoopsAreJazzys) {
  WaypointDrive drive;
  auto goal = over({2.0, 3.0, 1.0});
  goal.goal_index(2);
  goal.number_of_loops(2);
  drive.go(30.0, {{1.0, [&] { drive.waypoints.send(goal); }}}, "waypoint_pause: 0.2");
  EXPECT_THAT(drive.waypoints.goals[0].ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_THAT(visited(drive.waypoints.goals[0]), ElementsAre(2, 0, 1, 2, 0, 1, 2));
}

// The second lies in a wall, code 206 of Nav2. Humble's result has its index alone.
TEST(FollowWaypoints, OneThatIsMissedIsTheLastOrNot) {
  for (const bool stop : {true, false}) {
    WaypointDrive drive;
    drive.world.wall = 10.0;
    drive.go(20.0,
             {{1.0,
               [&] {
                 drive.waypoints.send(over({2.0, 11.0, 1.0}));
               }}},
             std::string("stop_on_failure: ") + (stop ? "true" : "false"));
    const auto& sent = drive.waypoints.goals[0];
    EXPECT_THAT(sent.ends, ElementsAre(stop ? GoalStatus::aborted : GoalStatus::succeeded));
    EXPECT_EQ(sent.result.error_code(), stop ? 600 : 0);
    EXPECT_THAT(sent.result.error_msg(), HasSubstr(stop ? "goal 1 of the list was missed: no plan" : ""));
    ASSERT_EQ(sent.result.missed_waypoints().size(), 1U);
    EXPECT_EQ(sent.result.missed_waypoints()[0].index(), 1U);
    EXPECT_EQ(sent.result.missed_waypoints()[0].error_code(), 206);
    EXPECT_EQ(sent.result.missed_waypoints()[0].goal().pose().position().x(), 11.0);
    EXPECT_NEAR(drive.world.x, stop ? 2.0 : 1.0, 1e-9);
  }
}

// The base stands from the pause after the first waypoint on, and is released 20 s later: the list goes on,
// nothing is missed.
TEST(FollowWaypoints, AListWaitsForABaseThatStands) {
  WaypointDrive drive;
  drive.world.base = base_state(BaseState_Constants::DRIVING);
  drive.go(40.0,
           {{1.0,
             [&] {
               drive.waypoints.send(over({2.0, 4.0}));
             }},
            {3.5, [&] { drive.world.base = base_state(BaseState_Constants::CLIFF, true, "cliff: left"); }},
            {23.5, [&] { drive.world.base = base_state(BaseState_Constants::WAITING); }}},
           "waypoint_pause: 1.0");
  EXPECT_THAT(drive.waypoints.goals[0].ends, ElementsAre(GoalStatus::succeeded));
  EXPECT_THAT(drive.waypoints.goals[0].result.missed_waypoints(), IsEmpty());
  EXPECT_NEAR(drive.waypoints.goals[0].ended_at, 25.5, 0.3);
}

TEST(FollowWaypoints, AListThatComesWhileTheBaseStandsEndsAtOnce) {
  WaypointDrive drive;
  drive.world.base = base_state(BaseState_Constants::CLIFF, true, "cliff: left");
  drive.go(6.0, {{1.0,
                  [&] {
                    drive.waypoints.send(over({2.0, 4.0}));
                  }},
                 {2.0, [&] { drive.world.base = base_state(BaseState_Constants::WAITING); }}});
  const auto& sent = drive.waypoints.goals[0];
  EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(sent.result.error_code(), 600);
  EXPECT_EQ(sent.result.error_msg(), "the base stands: cliff: left; until release_stop");
  EXPECT_NEAR(sent.ended_at, 1.0, 0.051);
  EXPECT_EQ(drive.world.x, 0.0);
}

template <class Action>
typename SentGoals<Action>::Goal missed_in(const std::string& distro) {
  World world;
  world.wall = 10.0;
  SentGoals<Action> sent;
  run_with_script("ros_distro: " + distro + "\ncomponents: {navigator: {}}", 15.0, [&](bw::Setup& setup) {
    world.configure(setup);
    sent.declare(setup, "follow_waypoints");
    at_times(setup, {{1.0, [&] { sent.send(over<Action>({2.0, 11.0})); }}});
  });
  return sent.goals[0];
}

TEST(FollowWaypoints, OtherDistributionsAreToldInTheirWords) {
  const auto humble = missed_in<HumbleNav2::FollowWaypoints>("humble");
  EXPECT_THAT(humble.ends, ElementsAre(GoalStatus::aborted));
  EXPECT_THAT(humble.result.missed_waypoints(), ElementsAre(1));
  const auto kilted = missed_in<KiltedNav2::FollowWaypoints>("kilted");
  EXPECT_THAT(kilted.ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(kilted.result.error_code(), 603);
  ASSERT_EQ(kilted.result.missed_waypoints().size(), 1U);
  EXPECT_EQ(kilted.result.missed_waypoints()[0].waypoint_status(), 3);
  EXPECT_THAT(kilted.result.missed_waypoints()[0].error_msg(), HasSubstr("the goal lies in a wall"));
}

TEST(FollowWaypoints, ListsThatCannotBeDrivenAreRefusedAtOnce) {
  WaypointDrive drive;
  auto mars = over({1.0, 2.0});
  mars.poses()[1].header().frame_id("mars");
  auto beyond = over({1.0, 2.0});
  beyond.goal_index(2);
  drive.go(8.0, {{1.0, [&] { drive.to_pose.send({}); }},  // no pose: frame ''
                 {1.5, [&] {
                    drive.waypoints.send({});
                    drive.waypoints.send(mars);
                    drive.waypoints.send(beyond);
                  }}});
  const std::string sentences[] = {"the list of poses is empty", "pose 1 of 2: the goal is in frame 'mars'",
                                   "goal_index 2 is none of 2 poses"};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& sent = drive.waypoints.goals[i];
    EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::aborted));
    EXPECT_EQ(sent.result.error_code(), 600);
    EXPECT_THAT(sent.result.error_msg(), HasSubstr(sentences[i]));
    EXPECT_NEAR(sent.ended_at, 1.5, 0.011);
  }
  EXPECT_EQ(drive.world.x, 0.0);
}

TEST(FollowWaypoints, CanceledItEndsWhenTheRobotStandsAndInAPauseAtOnce) {
  for (const double when : {2.0, 3.5}) {  // on the way to the first, and in the pause after it
    WaypointDrive drive;
    drive.go(8.0,
             {{1.0,
               [&] {
                 drive.waypoints.send(over({2.0, 9.0}));
               }},
              {when, [&] { drive.waypoints.cancel(0); }}},
             "waypoint_pause: 2.0");
    const auto& sent = drive.waypoints.goals[0];
    EXPECT_THAT(sent.ends, ElementsAre(GoalStatus::canceled));
    EXPECT_EQ(sent.result.error_msg(), "canceled by request");
    EXPECT_THAT(sent.result.missed_waypoints(), IsEmpty());
    EXPECT_NEAR(sent.ended_at, when == 2.0 ? 2.1 : 3.5, 0.06);
    EXPECT_NEAR(drive.world.x, when == 2.0 ? 1.0 : 2.0, 0.11);
  }
}

TEST(FollowWaypoints, AnyNewerGoalPreemptsTheList) {
  for (const double when : {2.0, 3.5}) {
    WaypointDrive drive;
    drive.go(16.0,
             {{1.0,
               [&] {
                 drive.waypoints.send(over({2.0, 9.0}));
               }},
              {when,
               [&] {
                 drive.waypoints.send(over({4.0, 5.0}));
               }},
              {8.0, [&] { drive.to_pose.send(to_pose_goal(6.0)); }}},
             "waypoint_pause: 2.0");
    EXPECT_THAT(drive.waypoints.goals[0].ends, ElementsAre(GoalStatus::aborted));
    EXPECT_EQ(drive.waypoints.goals[0].result.error_msg(), "preempted by a newer goal");
    EXPECT_NEAR(drive.waypoints.goals[0].ended_at, when, 0.011);
    EXPECT_NEAR(drive.waypoints.goals[1].ended_at, 8.0, 0.011);
    EXPECT_THAT(drive.to_pose.goals[0].ends, ElementsAre(GoalStatus::succeeded));
    EXPECT_NEAR(drive.world.x, 6.0, 1e-9);
  }
}

TEST(FollowWaypoints, WhatSomebodyElseCancelsEndsAborted) {
  WaypointDrive drive;
  drive.go(5.0, {{1.0,
                  [&] {
                    drive.waypoints.send(over({9.0, 1.0}));
                  }},
                 {2.0, [&] { drive.cancel_goal.publish({}); }}});
  EXPECT_THAT(drive.waypoints.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(drive.waypoints.goals[0].result.error_msg(), "canceled by request");
}

// A client is told within lost_patience of each of its goals, where a goal of the graph would wait.
TEST(FollowWaypoints, AListOfARobotThatIsLostEnds) {
  WaypointDrive drive;
  drive.world.is_lost = true;
  drive.go(15.0, {{1.0, [&] { drive.waypoints.send(over({9.0, 1.0})); }}});
  EXPECT_THAT(drive.waypoints.goals[0].ends, ElementsAre(GoalStatus::aborted));
  EXPECT_EQ(drive.waypoints.goals[0].result.missed_waypoints().at(0).error_code(), 202);
}

}  // namespace
}  // namespace bw
