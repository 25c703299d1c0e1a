#include "components/local_planner/adaptor/follow_messages.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bw {
namespace {

using bandwagon_msgs::msg::FollowRequest;

TEST(GoalTolerance, IsTheRequestsAndTheUsualWhereThatNamesNone) {
  FollowRequest request;
  EXPECT_EQ(goal_tolerance_of(request), GoalTolerance{});
  request.xy_tolerance(0.5);
  EXPECT_EQ(goal_tolerance_of(request), (GoalTolerance{0.5, GoalTolerance{}.yaw}));
  request.xy_tolerance(std::nan(""));
  EXPECT_EQ(goal_tolerance_of(request), GoalTolerance{});
}

// Half of the distance and a third of the heading; a figure of the planner's own as long as it lies inside.
TEST(GoalTolerance, ThePlannerEndsInside) {
  PlanningProblem problem{.goal_tolerance = {0.4, 0.6}};
  EXPECT_EQ(arrival_tolerance(problem, {}), (GoalTolerance{0.2, 0.6 / 3.0}));
  EXPECT_EQ(arrival_tolerance(problem, {.xy_goal_tolerance = 0.4, .yaw_goal_tolerance = 0.1}),
            (GoalTolerance{0.4, 0.1}));
  EXPECT_EQ(arrival_tolerance(problem, {.xy_goal_tolerance = 0.41, .yaw_goal_tolerance = 0.7}),
            (GoalTolerance{0.2, 0.6 / 3.0}));
  EXPECT_EQ(arrival_tolerance({}, {}).xy, 0.1);
  EXPECT_NEAR(arrival_tolerance({}, {}).yaw, 0.1, 1e-12);
}

TEST(GoalTolerance, OneThatIsNotUsedIsComplainedOf) {
  EXPECT_EQ(tolerance_complaint({0.4, 0.6}, {}), "");
  EXPECT_EQ(tolerance_complaint({0.4, 0.6}, {.xy_goal_tolerance = 0.4}), "");
  EXPECT_EQ(
      tolerance_complaint({0.4, 0.6}, {.xy_goal_tolerance = 0.5, .yaw_goal_tolerance = 0.1}),
      "xy_goal_tolerance 0.5 m and yaw_goal_tolerance 0.1 rad must not exceed what the navigator calls reached, "
      "0.4 m and 0.6 rad: 0.2 m and 0.1 rad are used");
}

}  // namespace
}  // namespace bw
