#include "components/local_planner/dwa/led_plan.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/plan_line.hpp"
#include "components/model/random.hpp"
#include "tests/components/local_planner/planner_drive.hpp"
#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw::dwa {
namespace {

double least_distance(const std::vector<Pose2>& plan, const Vector2& p) {
  const PlanLine line(plan, plan.front().position(), 0.0);
  return line.nearest(p, 0.0, line.length()).beside;
}

TEST(LedPlan, IsThePlanWhereThatIsFree) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.discs = {{{3.0, 0.6}, 0.25}};  // a robot of 0.3 m passes with 5 cm
  EXPECT_EQ(led_plan(problem, 0.05), problem.plan);
  problem.obstacles.discs = {{{7.0, 0.0}, 0.25}};  // farther than it looks
  EXPECT_EQ(led_plan(problem, 0.05), problem.plan);
}

TEST(LedPlan, LeadsAroundADiscOnTheShorterSide) {
  // Rim to robot: 0.3 + 0.3 + 0.05 m from the middle of the disc, and 0.15 m more where that costs less than
  // twice the length. The shortest path around a circle of r = 0.8 m, 0.15 m off the middle, over 4 m is some
  // 0.35 m longer.
  PlanningProblem problem = problem_to({8, 0, 0});
  const Vector2 disc(2.0, 0.15);
  problem.obstacles.discs = {{disc, 0.3}};
  const std::vector<Pose2> led = led_plan(problem, 0.05);
  EXPECT_GE(least_distance(led, disc), 0.65 - 0.01);
  EXPECT_LE(least_distance(led, disc), 0.80 + 0.11) << "a cell";
  const PlanLine line(led, {0, 0}, 0.0);
  EXPECT_LT(line.length(), 8.6);
  EXPECT_EQ(led.front().position(), Vector2(0.0, 0.0));
  EXPECT_EQ(led.back(), problem.plan.back());
  EXPECT_LT(line.at(2.0).y(), -0.4) << "to the right, where less is in the way";
}

TEST(LedPlan, WhoStandsIsInTheWayWhoWalksIsNot) {
  PlanningProblem problem = problem_to({8, 0, 0});
  Mover mover;
  mover.position = {2.0, 0.1};
  problem.movers = {mover};
  EXPECT_NE(led_plan(problem, 0.05), problem.plan);
  problem.movers[0].velocity = {0.0, 0.5};
  EXPECT_EQ(led_plan(problem, 0.05), problem.plan);
  problem.movers[0] = mover;
  problem.movers[0].confidence = 0.4;
  EXPECT_EQ(led_plan(problem, 0.05), problem.plan) << "possible people are not";
}

TEST(LedPlan, WithoutAWayAroundItIsThePlan) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.segments = {{{2.0, -9.0}, {2.0, 9.0}}};
  EXPECT_EQ(led_plan(problem, 0.05), problem.plan);
  problem.obstacles = {};
  problem.plan = {{0, 0, 0}, {3, 0, 0}};
  problem.obstacles.discs = {{{3.0, 0.0}, 0.3}};  // the goal itself
  EXPECT_EQ(led_plan(problem, 0.05), problem.plan);
}

TEST(LedPlan, FindsTheGapInAWall) {
  // Closed but for 1 m between y = 1.5 and 2.5.
  PlanningProblem problem = problem_to({5, 0, 0});
  problem.obstacles.segments = {{{2.0, -9.0}, {2.0, 1.5}}, {{2.0, 2.5}, {2.0, 9.0}}};
  const std::vector<Pose2> led = led_plan(problem, 0.05);
  const PlanLine line(led, {0, 0}, 0.0);
  EXPECT_LT(line.nearest({2.0, 2.0}, 0.0, line.length()).beside, 0.2);
}

TEST(LedPlan, MovesWithTheFrameAndTheMirror) {
  Random random(16);
  int led = 0;
  for (int i = 0; i < 60; ++i) {
    const PlanningProblem problem = random_scene(random);
    const std::vector<Pose2> plan = led_plan(problem, 0.05);
    led += plan != problem.plan;
    const double x = random.uniform(-9, 9), y = random.uniform(-9, 9);
    const Pose2 X{x, y, random.uniform(-3, 3)};
    const std::vector<Pose2> there = led_plan(moved(problem, X), 0.05);
    const std::vector<Pose2> mirror = led_plan(mirrored(problem), 0.05);
    ASSERT_EQ(plan.size(), there.size()) << i;
    ASSERT_EQ(plan.size(), mirror.size()) << i;
    for (std::size_t k = 0; k < plan.size(); ++k) {
      EXPECT_LE((X * plan[k].position() - there[k].position()).norm(), 1e-9) << i;
      EXPECT_LE((Vector2(plan[k].x, -plan[k].y) - mirror[k].position()).norm(), 1e-9) << i;
    }
  }
  EXPECT_GT(led, 10) << "hardly a plan is blocked";
}

}  // namespace
}  // namespace bw::dwa
