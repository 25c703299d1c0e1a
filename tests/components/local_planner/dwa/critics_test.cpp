// Each term by hand.
#include "components/local_planner/dwa/critics.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/components/local_planner/planner_drive.hpp"

namespace bw::dwa {
namespace {

// A roll-out that ends there, far from everything.
RollOut ending_at(const Pose2& end, double travel) {
  return {.twist = {0.6, 0.2}, .end = end, .travel = travel, .gap = 9.0};
}

TEST(Critics, MeasurePlanAndGoal) {
  const PlanningProblem problem = problem_to({8, 0, 0});
  const Course course = course_of(problem.plan, problem);
  // 1 m on, 0.2 m to the left, rotated left by 90 degrees: the point 0.325 m before it is 0.525 m beside the
  // plan.
  const Critique c = critique(ending_at({1.0, 0.2, std::numbers::pi / 2.0}, 1.1), course, problem);
  EXPECT_NEAR(c.path_dist, 0.2, 1e-12);
  EXPECT_NEAR(c.path_align, 0.525, 1e-12);
  EXPECT_NEAR(c.goal_dist, 7.0, 1e-12);
  EXPECT_NEAR(c.goal_align, 7.0, 1e-12);
  EXPECT_EQ(c.base_obstacle, 0.0);
  EXPECT_NEAR(c.slowness, 0.4, 1e-12);
  EXPECT_NEAR(c.turn_rate_change, 0.2, 1e-12);
  // Straight ahead: the point is 0.325 m further on.
  const Critique ahead = critique(ending_at({1.0, 0.2, 0.0}, 1.1), course, problem);
  EXPECT_NEAR(ahead.goal_align, 7.0 - 0.325, 1e-12);
  EXPECT_NEAR(ahead.path_align, 0.2, 1e-12);
}

TEST(Critics, AtTheGoalWhoLooksAlongThePlanIsAligned) {
  const PlanningProblem problem = problem_to({1, 0, 0});
  const Critique c = critique(ending_at({1.0, 0.0, 0.0}, 1.0), course_of(problem.plan, problem), problem);
  EXPECT_NEAR(c.path_dist + c.path_align + c.goal_dist + c.goal_align, 0.0, 1e-12);
  const Critique beyond =
      critique(ending_at({1.2, 0.0, 0.0}, 1.2), course_of(problem.plan, problem), problem);
  EXPECT_NEAR(beyond.path_dist, 0.2, 1e-12) << "past the goal is beside the plan";
}

TEST(Critics, ThePlanOnTheOtherSideOfAWallIsNoShortcut) {
  // 3 m out, 0.5 m to the left, 3 m back. Half a metre on and 0.4 m to the left one is 0.1 m from the path
  // back, but the path driven cannot have led there.
  PlanningProblem problem = problem_to({0, 0.5, 0});
  problem.plan = {{0, 0, 0}, {3, 0, 0}, {3, 0.5, 0}, {0, 0.5, 0}};
  const Critique c = critique(ending_at({0.5, 0.4, 0.0}, 0.7), course_of(problem.plan, problem), problem);
  EXPECT_NEAR(c.path_dist, 0.4, 1e-12);
  EXPECT_NEAR(c.goal_dist, 6.0, 1e-12);
}

TEST(Critics, ObstacleCostIsThatOfAnInflatedCostmap) {
  EXPECT_EQ(obstacle_cost(0.0), 1.0);
  EXPECT_NEAR(obstacle_cost(0.2), std::exp(-3.0 * 0.2), 1e-12);
  EXPECT_EQ(obstacle_cost(0.55), 0.0);
}

TEST(Critics, AreWeightedAndSummed) {
  const Critique c{.path_dist = 0.1,
                   .path_align = 0.2,
                   .goal_dist = 3.0,
                   .goal_align = 2.0,
                   .base_obstacle = 0.5,
                   .slowness = 0.4,
                   .turn_rate_change = 0.3};
  const CriticOptions options{.path_dist_scale = 1.0,
                              .path_align_scale = 2.0,
                              .goal_dist_scale = 3.0,
                              .goal_align_scale = 4.0,
                              .base_obstacle_scale = 5.0};
  // 0.1 + 9 + 2.5, 0.4 for the speed and half of 0.3 for the turn rate; the aligning terms are 0.4 + 8.
  EXPECT_NEAR(cost_without_align(c, options), 12.15, 1e-12);
  EXPECT_NEAR(cost(c, options), 20.55, 1e-12);
}

}  // namespace
}  // namespace bw::dwa
