#include <array>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <std_msgs/msg/empty.hpp>

#include "tests/components/navigator/navigator_world.hpp"

namespace bw {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(NavigatorComponent, DrivesToTheGoalOfTheGraph) {
  World world;
  run_with_script("components: {navigator: {parameters: {goal: {enabled: true, x: 3.0}}}}", 6.0,
                  [&](bw::Setup& setup) { world.configure(setup); });
  ASSERT_FALSE(world.statuses.empty());
  const NavigationStatus& end = world.statuses.back();
  EXPECT_EQ(end.status(), NavigationStatus_Constants::SUCCEEDED);
  EXPECT_EQ(end.reason(), "reached");
  EXPECT_EQ(end.goal_id(), 1U);
  EXPECT_NEAR(world.x, 3.0, 1e-9);
  EXPECT_EQ(world.mode, FollowRequest_Constants::STOP);
  EXPECT_EQ(world.plans, 3);  // at once, and after 1 and 2 s; at 3 s it is within the tolerance
  // Accepted, executing, feedback each 0.2 s, succeeded.
  EXPECT_EQ(world.statuses.front().status(), NavigationStatus_Constants::ACCEPTED);
  EXPECT_NEAR(static_cast<double>(world.statuses.size()), 2 + 15 + 1, 2);
}

// Variances of 0.02 m^2 and the covariance c between: 0.02 + c along the worst axis, two standard deviations of 0.297 m
// for 0.002 and 0.303 m for 0.003, where 0.3 m are allowed.
TEST(NavigatorComponent, GoesByTheWorstAxisOfTheCovariance) {
  for (const double c : {0.002, 0.003}) {
    World world;
    world.covariance << 0.02, c, 0.0, c, 0.02, 0.0, 0.0, 0.0, 0.01;
    run_with_script("components: {navigator: {parameters: {goal: {enabled: true, x: 3.0}}}}", 14.0,
                    [&](bw::Setup& setup) { world.configure(setup); });
    EXPECT_EQ(world.statuses.back().status(),
              c < 0.0025 ? NavigationStatus_Constants::SUCCEEDED : NavigationStatus_Constants::ABORTED);
  }
}

// 3 m out, 1 m back, 2 m out at 1 m/s with a second between: succeeded three times, 2, 1 and 0 goals follow.
TEST(NavigatorComponent, DrivesTheGoalsOfTheGraphOneAfterTheOther) {
  World world;
  run_with_script(
      "components: {navigator: {parameters: {goals: [{x: 3.0}, {x: 2.0}, {x: 4.0}], waypoint_pause: 1.0}}}",
      14.0, [&](bw::Setup& setup) { world.configure(setup); });
  std::vector<std::pair<std::uint64_t, std::uint32_t>> ends;
  for (const NavigationStatus& status : world.statuses) {
    if (status.status() == NavigationStatus_Constants::SUCCEEDED)
      ends.emplace_back(status.goal_id(), status.number_of_goals_remaining());
  }
  EXPECT_THAT(ends, ::testing::ElementsAre(std::pair(1, 2), std::pair(2, 1), std::pair(3, 0)));
  EXPECT_NEAR(world.x, 4.0, 1e-9);
}

// A person sends the robot elsewhere while the first of two goals is driven: the list is over.
TEST(NavigatorComponent, AGoalFromOutsideEndsTheList) {
  World world;
  run_with_script(
      "components: {navigator: {parameters: {goals: [{x: 30.0}, {x: 2.0}]}}}", 12.0, [&](bw::Setup& setup) {
        world.configure(setup);
        setup.every(
            Duration::milliseconds(3000), "goals",
            [out = setup.output<geometry_msgs::msg::PoseStamped>("goal_pose")](const Tick& tick) mutable {
              if (tick.sequence == 0) out.publish(goal(6.0));
            });
      });
  EXPECT_EQ(world.statuses.back().status(), NavigationStatus_Constants::SUCCEEDED);
  EXPECT_EQ(world.statuses.back().goal_id(), 2U);
  for (const NavigationStatus& status : world.statuses) {
    if (status.goal_id() == 2 || status.status() == NavigationStatus_Constants::ABORTED) {
      EXPECT_EQ(status.number_of_goals_remaining(), 0U);
    }
  }
  EXPECT_NEAR(world.x, 6.0, 1e-9);
}

TEST(NavigatorComponent, TellsPlannerAndJudgeWithinWhatTheGoalIsReached) {
  for (const bool is_set : {false, true}) {
    World world;
    const std::string set = is_set ? ", xy_tolerance: 0.7, yaw_tolerance: 0.9" : "";
    run_with_script("components: {navigator: {parameters: {goal: {enabled: true, x: 3.0}" + set + "}}}", 3.0,
                    [&](bw::Setup& setup) { world.configure(setup); });
    ASSERT_FALSE(world.statuses.empty());
    for (const NavigationStatus& status : world.statuses) {
      EXPECT_EQ(status.xy_tolerance(), is_set ? 0.7 : 0.2);
      EXPECT_EQ(status.yaw_tolerance(), is_set ? 0.9 : 0.3);
    }
    EXPECT_EQ(world.last_follow.xy_tolerance(), is_set ? 0.7 : 0.2);
    EXPECT_EQ(world.last_follow.yaw_tolerance(), is_set ? 0.9 : 0.3);
  }
}

TEST(NavigatorComponent, TakesGoalsFromTheTopicAndRefusesUnknownFrames) {
  World world;
  run_with_script("components: {navigator: {}}", 10.0, [&](bw::Setup& setup) {
    world.configure(setup);
    setup.every(Duration::milliseconds(1000), "goals",
                [out = setup.output<geometry_msgs::msg::PoseStamped>("goal_pose")](const Tick& tick) mutable {
                  if (tick.sequence == 0) out.publish(goal(5.0));
                  if (tick.sequence == 2) out.publish(goal(1.0, "mars"));
                  if (tick.sequence == 3) out.publish(goal(-1.0));
                });
  });
  EXPECT_EQ(world.statuses.back().status(), NavigationStatus_Constants::SUCCEEDED);
  EXPECT_EQ(world.statuses.back().goal_id(), 3U);
  EXPECT_NEAR(world.x, -1.0, 1e-9);
  std::string refused;
  std::string preempted;
  for (const NavigationStatus& status : world.statuses) {
    if (status.status() != NavigationStatus_Constants::ABORTED) continue;
    (status.goal_id() == 2 ? refused : preempted) = status.reason();
  }
  EXPECT_THAT(refused, HasSubstr("frame 'mars'"));
  EXPECT_EQ(preempted, "preempted by goal 3");
}

TEST(NavigatorComponent, CancelStandsStillAndSaysSo) {
  World world;
  run_with_script(
      "components: {navigator: {parameters: {goal: {enabled: true, x: 30.0}}}}", 5.0, [&](bw::Setup& setup) {
        world.configure(setup);
        setup.every(Duration::milliseconds(3000), "cancel",
                    [out = setup.output<std_msgs::msg::Empty>("cancel_goal")](const Tick&) mutable {
                      out.publish({});
                    });
      });
  EXPECT_EQ(world.statuses.back().status(), NavigationStatus_Constants::CANCELED);
  EXPECT_NEAR(world.x, 2.0, 0.16);  // from 1 s to 3 s
  // One line where it begins, one where it ends; that it is being canceled is no news for people.
  EXPECT_THAT(world.log, ElementsAre("goal 1: to (30.00, 0.00, 0.00)", "goal 1: canceled by request"));
}

// A reader that asks for what came before it is only matched by a writer that keeps the newest message.
TEST(NavigatorComponent, KeepsItsLastStatusForWhoeverComesLate) {
  World world;
  std::vector<std::uint8_t> heard;
  run_with_script("components: {navigator: {parameters: {goal: {enabled: true, x: 1.0}}}}", 4.0,
                  [&](bw::Setup& setup) {
                    world.configure(setup);
                    setup.input<NavigationStatus>(
                        "navigation_status", Qos::latched(),
                        [&](const auto& status, const Tick&) { heard.push_back(status.status()); });
                  });
  ASSERT_FALSE(heard.empty());
  EXPECT_EQ(heard.back(), NavigationStatus_Constants::SUCCEEDED);
}

geometry_msgs::msg::PoseStamped rotated_goal(double x, std::array<double, 4> xyzw) {
  geometry_msgs::msg::PoseStamped message = goal(x);
  auto& q = message.pose().orientation();
  q.x(xyzw[0]);
  q.y(xyzw[1]);
  q.z(xyzw[2]);
  q.w(xyzw[3]);
  return message;
}

// (0, 0, 1, 1) and (0, 0, 0.01, 0.01) are a quarter turn to the left, whatever their length.
TEST(NavigatorComponent, TakesQuaternionsOfAnyLengthButNone) {
  World world;
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  run_with_script("components: {navigator: {}}", 8.0, [&](bw::Setup& setup) {
    world.configure(setup);
    setup.every(Duration::milliseconds(1000), "goals",
                [out = setup.output<geometry_msgs::msg::PoseStamped>("goal_pose")](const Tick& tick) mutable {
                  if (tick.sequence == 0) out.publish(rotated_goal(30.0, {0, 0, 0, 0}));
                  if (tick.sequence == 1) out.publish(rotated_goal(30.0, {0, 0, kNan, 1}));
                  if (tick.sequence == 2) out.publish(rotated_goal(kNan, {0, 0, 0, 1}));
                  if (tick.sequence == 3) out.publish(rotated_goal(30.0, {0, 0, 1, 1}));
                  if (tick.sequence == 4) out.publish(rotated_goal(30.0, {0, 0, 0.01, 0.01}));
                });
  });
  std::vector<std::string> refused;
  std::vector<double> headings;
  for (const NavigationStatus& status : world.statuses) {
    if (status.status() == NavigationStatus_Constants::ABORTED && status.goal_id() <= 3)
      refused.push_back(status.reason());
    if (status.status() == NavigationStatus_Constants::ACCEPTED)
      headings.push_back(from_pose(status.goal().pose()).theta);
  }
  EXPECT_THAT(
      refused,
      ElementsAre("the goal is no pose: the quaternion has length 0 (no rotation is x 0, y 0, z 0, w 1)",
                  "the goal is no pose: the quaternion is not finite",
                  "the goal is no pose: the position is not finite"));
  EXPECT_THAT(headings, ElementsAre(DoubleNear(1.5707963, 1e-6), DoubleNear(1.5707963, 1e-6)));
}

}  // namespace
}  // namespace bw
