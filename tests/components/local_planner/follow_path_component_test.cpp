// follow_path as Nav2's behaviour tree and people use it: a robot that obeys at once on a straight path
// through an empty map. Steps are 0.02 s, cycles 0.1 s, v_max is 1 m/s and the acceleration 1 m/s^2. Codes
// are those of FollowPath's result.
#include <algorithm>
#include <functional>
#include <limits>
#include <memory>

#include <gtest/gtest.h>
#include <lyrical/nav2_msgs/action/follow_path.hpp>

#include "tests/components/local_planner/follow_path_rig.hpp"
#include "tests/components/local_planner/random_path.hpp"

namespace bw {
namespace {

namespace mode = bandwagon_msgs::msg::FollowRequest_Constants;
namespace follow = bandwagon_msgs::msg::FollowStatus_Constants;
using Rig = FollowPathRig<>;
using Goal = Rig::Goal;

const std::string kLead = "parameters: {command_lead: 0.1}";

void expect_end(const GoalStory& story, GoalStatus status, int code, const std::string& text) {
  EXPECT_TRUE(story.is_accepted);
  EXPECT_EQ(story.ends, 1);
  EXPECT_EQ(story.status, status);
  EXPECT_EQ(story.code, code);
  EXPECT_NE(story.text.find(text), std::string::npos) << story.text;
}

TEST(FollowPath, DrivesToTheEndTellsOfItEachCycleAndLeavesTheRobotStanding) {
  Rig rig;
  rig.settings = kLead;
  rig.at[5] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 3))); };
  rig.run(12.0);
  ASSERT_EQ(rig.goals.size(), 1U);
  expect_end(rig.goals[0], GoalStatus::succeeded, 0, "");
  EXPECT_LT((rig.X_MB.position() - Vector2(3, 0)).norm(), 0.25);
  EXPECT_EQ(rig.commands.back().second, Twist2{});
  EXPECT_LE(rig.commands.back().first, rig.goals[0].ended + 1e-9) << "silent when it is over";
  // One feedback in each cycle but the last, which is the result.
  const auto cycles = static_cast<double>((rig.goals[0].ended - 0.12) / 0.1);
  EXPECT_NEAR(static_cast<double>(rig.feedback.size()), cycles, 1.0);
  for (std::size_t i = 1; i < rig.feedback.size(); ++i)
    EXPECT_LE(rig.feedback[i].distance_to_goal(), rig.feedback[i - 1].distance_to_goal() + 0.05F) << i;
  EXPECT_NEAR(rig.feedback.front().distance_to_goal(), 3.0F, 0.05F);
  EXPECT_EQ(rig.statuses.back().status(), follow::IDLE);
}

// A base that goes on by itself is waited for. A cycle is 0.1 s.
TEST(FollowPath, ABaseThatHasToBeReleasedEndsItWithItsReason) {
  namespace states = bandwagon_msgs::msg::BaseState_Constants;
  Rig rig;
  rig.settings = kLead;
  rig.at[5] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 6))); };
  rig.at[50] = [&] {
    rig.base.state(states::BACKING_OFF);
    rig.base.reason("bumper left");
  };
  rig.at[100] = [&] { rig.base.is_latched(true); };
  rig.at[150] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 6))); };
  rig.at[200] = [&] { rig.base = {}; };
  rig.at[205] = [&] { rig.send(Rig::to_goal(Rig::straight(rig.X_MB.x, 6))); };
  rig.run(15.0);
  ASSERT_EQ(rig.goals.size(), 3U);
  const std::string reason = "the base stands: bumper left; until release_stop";
  expect_end(rig.goals[0], GoalStatus::aborted, 105, reason);
  EXPECT_NEAR(rig.goals[0].ended, 2.05, 0.06);
  expect_end(rig.goals[1], GoalStatus::aborted, 105, reason);
  EXPECT_NEAR(rig.goals[1].ended, 3.05, 0.06);
  expect_end(rig.goals[2], GoalStatus::succeeded, 0, "");
}

// The tree sends a path each second, from where the robot is. 20 m at 1 m/s take 20 s; from 3 s on it drives
// at full speed.
TEST(FollowPath, ANewPathEachSecondCausesNoDip) {
  Rig rig;
  rig.settings = kLead;
  for (int second = 0; second < 15; ++second)
    rig.at[5 + 50 * second] = [&] { rig.send(Rig::to_goal(Rig::straight(rig.X_MB.x, 20))); };
  rig.run(30.0);
  ASSERT_EQ(rig.goals.size(), 15U);
  for (std::size_t i = 0; i + 1 < rig.goals.size(); ++i) {
    expect_end(rig.goals[i], GoalStatus::aborted, 100, "preempted");
    EXPECT_NEAR(rig.goals[i].ended, 0.1 + static_cast<double>(i + 1) + 0.02, 0.03) << i;
  }
  expect_end(rig.goals.back(), GoalStatus::succeeded, 0, "");
  double fastest = 0.0;
  for (const auto& [time, command] : rig.commands) {
    if (time > 17.0) break;
    ASSERT_GE(command.v, fastest - 0.02) << time;
    fastest = std::max(fastest, command.v);
  }
  EXPECT_GT(fastest, 0.95);
}

TEST(FollowPath, CancelStopsAtOnceAndForGood) {
  Rig rig;
  rig.settings = kLead;
  GoalId id;
  rig.at[5] = [&] { id = rig.send(Rig::to_goal(Rig::straight(0, 10))); };
  rig.at[100] = [&] { rig.cancel(id); };
  rig.at[101] = [&] { rig.cancel(id); };  // of a goal that has ended
  rig.run(5.0);
  expect_end(rig.goals[0], GoalStatus::canceled, 0, "canceled");
  EXPECT_NEAR(rig.goals[0].ended, 2.02, 0.03);
  EXPECT_EQ(rig.commands.back().second, Twist2{});
  EXPECT_NEAR(rig.commands.back().first, 2.02, 0.03);
}

struct Bad {
  const char* name;
  std::function<void(Goal&)> spoil;
  int code;
  const char* text;
};

std::vector<Bad> bad_goals() {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  return {
      {"Empty", [](Goal& g) { g.path().poses().clear(); }, 103, "the path is empty"},
      {"NotFinite", [=](Goal& g) { g.path().poses()[3].pose().position().x(kNan); }, 103,
       "pose 3 of the path"},
      {"NoHeading", [](Goal& g) { g.path().poses().back().pose().orientation().w(0.0); }, 103,
       "no orientation"},
      {"NoFrame", [](Goal& g) { g.path().header().frame_id(""); }, 102, "names no frame"},
      {"UnknownFrame", [](Goal& g) { g.path().header().frame_id("moon"); }, 102, "no transform from moon"},
      {"UnknownController", [](Goal& g) { g.controller_id("MPPI"); }, 101, "controller 'MPPI'"},
      {"UnknownGoalChecker", [](Goal& g) { g.goal_checker_id("x"); }, 100, "goal checker 'x'"},
      {"UnknownProgressChecker", [](Goal& g) { g.progress_checker_id("x"); }, 100, "progress checker 'x'"}};
}

class BadGoal : public testing::TestWithParam<Bad> {};
INSTANTIATE_TEST_SUITE_P(FollowPath, BadGoal, testing::ValuesIn(bad_goals()),
                         [](const auto& bad) { return bad.param.name; });

// As Nav2's controller_server: its client has the bad goal in hand, and could not cancel the one before.
TEST_P(BadGoal, EndsAtOnceAndTheDriveInHandWithIt) {
  Goal bad = Rig::to_goal(Rig::straight(0, 3));
  GetParam().spoil(bad);
  Rig alone;
  alone.at[5] = [&] { alone.send(bad); };
  alone.run(1.0);
  expect_end(alone.goals[0], GoalStatus::aborted, GetParam().code, GetParam().text);
  EXPECT_TRUE(alone.commands.empty());

  Rig rig;
  rig.settings = kLead;
  rig.at[5] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 3))); };
  rig.at[100] = [&] { rig.send(bad); };
  rig.run(12.0);
  expect_end(rig.goals[1], GoalStatus::aborted, GetParam().code, GetParam().text);
  expect_end(rig.goals[0], GoalStatus::aborted, 100, "preempted by a goal that cannot be followed");
  EXPECT_EQ(rig.commands.back().second, Twist2{});
  EXPECT_NEAR(rig.commands.back().first, 2.02, 0.03) << "at once, and for good";
}

TEST(FollowPath, OddPathsAreDriven) {
  const auto drive = [](const Goal& goal, double seconds = 15.0) {
    Rig rig;
    rig.settings = kLead;
    rig.at[5] = [&rig, goal] { rig.send(goal); };
    rig.run(seconds);
    expect_end(rig.goals[0], GoalStatus::succeeded, 0, "");
    return rig.X_MB;
  };
  EXPECT_LT((drive(Rig::to_goal({{2, 0, 0}})).position() - Vector2(2, 0)).norm(), 0.25) << "one pose";
  EXPECT_LT((drive(Rig::to_goal(Rig::straight(-0.1, -3))).position() - Vector2(-3, 0)).norm(), 0.25)
      << "behind";
  EXPECT_LT((drive(Rig::to_goal(Rig::straight(-5, 2))).position() - Vector2(2, 0)).norm(), 0.25)
      << "one that it is on already";
  const Pose2 in_robot = drive(Rig::to_goal(Rig::straight(0, 3), "base_link"));
  EXPECT_LT((in_robot.position() - Vector2(3, 0)).norm(), 0.25) << "of the frame's place when it came";
  std::vector<Pose2> in_odom;
  for (const Pose2& X_MP : Rig::straight(0, 3)) in_odom.push_back(inverse(kX_MO) * X_MP);
  EXPECT_LT((drive(Rig::to_goal(in_odom, "odom")).position() - Vector2(3, 0)).norm(), 0.25);
  std::vector<Pose2> fine;
  for (int i = 0; i < 100'000; ++i) fine.push_back({3.0 * i / 99'999, 0.0, 0.0});
  EXPECT_LT((drive(Rig::to_goal(fine)).position() - Vector2(3, 0)).norm(), 0.25);
}

/// How a path was driven.
struct Story {
  GoalStory goal;
  std::vector<Pose2> driven;  ///< each 0.1 s
  Rig rig;
};

std::unique_ptr<Story> drive_path(const std::vector<Pose2>& path, double seconds,
                                  const std::function<void(Story&)>& happens = {}) {
  auto story = std::make_unique<Story>();
  Rig& rig = story->rig;
  rig.settings = kLead;
  for (int step = 0; step < seconds / Rig::kStep; step += 5)
    rig.at[step] = [&story = *story] { story.driven.push_back(story.rig.X_MB); };
  rig.at[6] = [&rig, path] { rig.send(Rig::to_goal(path)); };
  if (happens) happens(*story);
  rig.run(seconds);
  story->goal = rig.goals.back();
  return story;
}

// From where the robot stands d metres out and back over the same line to 1 m behind. At 1 m/s it takes 2 d +
// 1 s, 2 s of speeding up and braking and 3 s of rotating by 180 degrees; the test waits for twice that.
TEST(FollowPath, APathThatComesBackOverItselfIsDrivenOutAndBack) {
  for (double d = 1.0; d <= 6.0; d += 1.0) {
    const auto story = drive_path(path_over({{0, 0}, {d, 0}, {-1, 0}}), 2.0 * (2.0 * d + 1.0 + 5.0));
    double farthest = 0.0;
    for (const Pose2& X : story->driven) farthest = std::max(farthest, X.x);
    EXPECT_GE(farthest, d - 0.25) << d;
    expect_end(story->goal, GoalStatus::succeeded, 0, "");
    EXPECT_LT((story->rig.X_MB.position() - Vector2(-1, 0)).norm(), 0.25) << d;
    EXPECT_NEAR(story->rig.feedback.front().distance_to_goal(), 2.0 * d + 1.0, 0.02)
        << d << ": all of it is ahead";
  }
}

// A square of 2 m that ends where it begins, and an eight that crosses itself at (2, 0): each position in its
// turn, within the 0.5 m by which a bend may be cut.
TEST(FollowPath, APathThatClosesOrCrossesItselfIsDrivenInOrder) {
  for (const std::vector<Vector2>& corners :
       {std::vector<Vector2>{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}},
        std::vector<Vector2>{{0, 0}, {4, 0}, {4, -2}, {2, -2}, {2, 2}}}) {
    const std::vector<Pose2> path = path_over(corners);
    const auto story = drive_path(path, 50.0);
    expect_end(story->goal, GoalStatus::succeeded, 0, "");
    const std::vector<Vector2> positions = positions_of(path);
    EXPECT_EQ(passed_in_order(positions, story->driven, 0.5), positions.size());
  }
}

// The same goal once more on the way back, at 7 s (3 m and a rotation take 6): the robot does not drive out
// again.
TEST(FollowPath, TheSamePathOnceMoreIsGoneOnWith) {
  const std::vector<Pose2> path = path_over({{0, 0}, {3, 0}, {-2, 0}});
  double then = 0.0;
  double farthest = -9.0;
  const auto story = drive_path(path, 26.0, [&](Story& s) {
    s.rig.at[451] = [&] {
      then = s.rig.X_MB.x;
      s.rig.send(Rig::to_goal(path));
    };
    for (int step = 452; step < 1300; step += 5)
      s.rig.at[step] = [&] { farthest = std::max(farthest, s.rig.X_MB.x); };
  });
  EXPECT_LT(then, 2.0);
  EXPECT_LE(farthest, then + 0.01);
  expect_end(story->goal, GoalStatus::succeeded, 0, "");
  EXPECT_LT((story->rig.X_MB.position() - Vector2(-2, 0)).norm(), 0.25);
}

bandwagon_msgs::msg::Obstacles everywhere() {
  bandwagon_msgs::msg::Obstacles obstacles;
  obstacles.discs().resize(1);
  obstacles.discs()[0].radius(5.0F);
  return obstacles;
}

// The robot stands in an obstacle from 2 s on: there is no free path. Cycles are at multiples of 0.1 s.
TEST(FollowPath, WithoutAWayItGivesUpAsPatienceSays) {
  const auto drive = [](const std::string& parameters) {
    Rig rig;
    rig.settings = "parameters: {command_lead: 0.1, " + parameters + "}";
    rig.at[5] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 10))); };
    rig.at[99] = [&] { rig.obstacles = everywhere(); };
    rig.run(16.0);
    EXPECT_EQ(rig.twist, Twist2{});
    return rig.goals[0];
  };
  const GoalStory patient = drive("failure_tolerance: 0.3");
  expect_end(patient, GoalStatus::aborted, 104, "no way for more than 0.3 s");
  EXPECT_NEAR(patient.ended, 2.35, 0.11);
  const GoalStory strict = drive("failure_tolerance: 0.0");
  expect_end(strict, GoalStatus::aborted, 106, "");
  EXPECT_NEAR(strict.ended, 2.05, 0.11);
  const GoalStory stoic = drive("failure_tolerance: -1.0");
  expect_end(stoic, GoalStatus::aborted, 105, "no progress");
  EXPECT_NEAR(stoic.ended, 12.0, 0.3);  // 10 s after it stood, which takes a cycle or two
}

TEST(FollowPath, WithoutOdometryItTimesOut) {
  Rig rig;
  rig.settings = "parameters: {command_lead: 0.1}, inputs: {odom: {max_age: 300ms, on_stale: stop}}";
  rig.at[5] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 10))); };
  rig.at[100] = [&] { rig.has_odometry = false; };
  rig.run(5.0);
  expect_end(rig.goals[0], GoalStatus::aborted, 107, "a needed input is stale");
  EXPECT_NEAR(rig.goals[0].ended, 2.7,
              0.15);  // 2.0 s, 0.3 s until it is stale, 0.3 s of waiting, up to two cycles
  EXPECT_EQ(rig.commands.back().second, Twist2{});
}

TEST(FollowPath, TheNewerOfTopicAndActionWinsAndTheOtherIsTold) {
  Rig rig;
  rig.settings = kLead;
  rig.at[5] = [&] { rig.request(7, mode::FOLLOW, Rig::straight(0, 10)); };
  rig.at[100] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 10))); };
  std::vector<bandwagon_msgs::msg::FollowStatus> during;
  rig.at[140] = [&] { rig.request(8, mode::STOP); };
  rig.at[199] = [&] { during = rig.statuses; };
  rig.at[200] = [&] { rig.request(9, mode::FOLLOW, Rig::straight(0, 10)); };
  rig.run(6.0);
  const auto at = [&](double seconds) { return during[static_cast<std::size_t>(seconds * 10.0)]; };
  EXPECT_EQ(at(1.5).status(), follow::FOLLOWING);
  EXPECT_EQ(at(2.4).status(), follow::FAILED);
  EXPECT_EQ(at(2.4).id(), 7U);
  EXPECT_EQ(at(2.4).reason(), "a goal of follow_path took over");
  EXPECT_EQ(at(3.5).id(), 8U) << "its stop is answered, and stops nobody else";
  expect_end(rig.goals[0], GoalStatus::aborted, 100, "a follow_request took over");
  EXPECT_NEAR(rig.goals[0].ended, 4.0, 0.05);
  EXPECT_EQ(rig.statuses.back().id(), 9U);
  EXPECT_EQ(rig.statuses.back().status(), follow::FOLLOWING);
  for (const auto& [time, command] : rig.commands) {
    if (time <= 2.0) continue;
    EXPECT_GT(command.v, 0.8) << time << ": it drove all the time";
  }
}

TEST(FollowPath, ADeactivatedControllerLeavesARobotThatStands) {
  Rig rig;
  rig.settings = kLead;
  rig.at[5] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 10))); };
  rig.at[100] = [&] { rig.change("deactivate"); };
  rig.at[120] = [&] { rig.send(Rig::to_goal(Rig::straight(0, 10))); };
  rig.at[150] = [&] { rig.change("activate"); };
  rig.at[200] = [&] { rig.send(Rig::to_goal(Rig::straight(rig.X_MB.x, 3))); };
  std::size_t commands = 0;
  rig.at[198] = [&] { commands = rig.commands.size(); };
  rig.run(14.0);
  expect_end(rig.goals[0], GoalStatus::aborted, 100, "");
  EXPECT_FALSE(rig.goals[0].text.empty());
  EXPECT_NEAR(rig.goals[0].ended, 2.02, 0.03);
  EXPECT_EQ(rig.commands.at(commands - 1).second, Twist2{});
  EXPECT_NEAR(rig.commands.at(commands - 1).first, 2.02, 0.03)
      << "nothing is left of the goal when it is active again";
  EXPECT_FALSE(rig.goals[1].is_accepted);
  expect_end(rig.goals[2], GoalStatus::succeeded, 0, "");
}

// Kilted and Lyrical want a stamp, and Lyrical's feedback says more.
TEST(FollowPath, SpeaksLyrical) {
  FollowPathRig<lyrical::nav2_msgs::action::FollowPath> rig;
  rig.head = "ros_distro: lyrical";
  rig.settings = "parameters: {command_lead: 0.1, enable_stamped_cmd_vel: auto}";
  rig.at[5] = [&] { rig.send(rig.to_goal(rig.straight(0, 3))); };
  rig.run(12.0);
  ASSERT_EQ(rig.goals[0].status, GoalStatus::succeeded) << rig.goals[0].text;
  EXPECT_EQ(rig.command_frame, "base_link");
  ASSERT_GT(rig.feedback.size(), 20U);
  const auto& tracking = rig.feedback[20].tracking_feedback();  // 2 s on its way
  EXPECT_EQ(tracking.header().frame_id(), "map");
  EXPECT_NEAR(tracking.position_tracking_error(), 0.0F, 0.05F);
  EXPECT_NEAR(
      tracking.robot_pose().pose().position().x() + static_cast<double>(tracking.remaining_path_length()),
      3.0, 0.06);
  EXPECT_NEAR(static_cast<double>(tracking.current_path_index()) * 0.05,
              tracking.robot_pose().pose().position().x(), 0.06);
}

}  // namespace
}  // namespace bw
