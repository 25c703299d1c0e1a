#include "components/local_planner/dwa/rotate_to_plan.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/components/local_planner/planner_drive.hpp"

namespace bw::dwa {
namespace {

// Looks along x; the plan leads away at `angle`.
PlanningProblem leading_off_at(double angle) {
  return problem_to({8.0 * std::cos(angle), 8.0 * std::sin(angle), 0.0});
}

std::optional<double> angle_of(RotateToPlan& rotate_to_plan, const PlanningProblem& problem) {
  return rotate_to_plan.angle(problem, course_of(problem.plan, problem), {});
}

TEST(RotateToPlan, BeginsBeyondItsThresholdAndEndsWhenThePlanLiesAhead) {
  RotateToPlan rotate_to_plan;
  EXPECT_FALSE(angle_of(rotate_to_plan, leading_off_at(0.9)).has_value()) << "1 rad is the threshold";
  EXPECT_NEAR(angle_of(rotate_to_plan, leading_off_at(1.1)).value(), 1.1, 1e-9);
  EXPECT_NEAR(angle_of(rotate_to_plan, leading_off_at(0.3)).value(), 0.3, 1e-9) << "it goes on";
  EXPECT_FALSE(angle_of(rotate_to_plan, leading_off_at(0.15)).has_value());
  EXPECT_FALSE(angle_of(rotate_to_plan, leading_off_at(0.3)).has_value())
      << "and begins anew beyond the threshold alone";
}

TEST(RotateToPlan, KeepsItsSideWhenThePlanIsBehind) {
  RotateToPlan rotate_to_plan;
  EXPECT_NEAR(angle_of(rotate_to_plan, leading_off_at(3.0)).value(), 3.0, 1e-9);
  // A little later the plan is seen a little to the right of straight behind.
  EXPECT_NEAR(angle_of(rotate_to_plan, leading_off_at(-3.0)).value(), 2.0 * std::numbers::pi - 3.0, 1e-9);
  rotate_to_plan.forget();
  EXPECT_NEAR(angle_of(rotate_to_plan, leading_off_at(-3.0)).value(), -3.0, 1e-9);
}

TEST(RotateToPlan, LooksASamplingDistanceAhead) {
  // A corner 0.2 m ahead: half a metre on, the plan is at (0.2, 0.3).
  PlanningProblem problem = problem_to({0, 0, 0});
  problem.plan = {{0, 0, 0}, {0.2, 0, 0}, {0.2, 5, 0}};
  RotateToPlan rotate_to_plan;
  EXPECT_FALSE(angle_of(rotate_to_plan, problem).has_value()) << "56 degrees";
  problem.pose.theta = -0.2;
  EXPECT_NEAR(angle_of(rotate_to_plan, problem).value(), std::atan2(0.3, 0.2) + 0.2, 1e-9);
}

TEST(RotateToPlan, ATurnCostsWhatIsLeftWhenItIsStopped) {
  // 0.6 rad/s for 0.1 s and stopped at 1.5 rad/s^2: 0.06 + 0.12.
  const PlanningProblem problem = problem_to({8, 0, 0});
  EXPECT_NEAR(rotation_left_over({0.0, 0.6}, 1.0, problem), 0.82, 1e-12);
  EXPECT_NEAR(rotation_left_over({0.0, 0.6}, -1.0, problem), 1.18, 1e-12);
  EXPECT_NEAR(rotation_left_over({0.0, -0.6}, -1.0, problem), 0.82, 1e-12);
}

}  // namespace
}  // namespace bw::dwa
