// The planner in closed loop with an ideal unicycle that takes its commands as they are.
#include "components/local_planner/teb/band_planner.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/footprint_check.hpp"
#include "components/model/differential_drive.hpp"
#include "tests/components/local_planner/planner_drive.hpp"

namespace bw::teb {
namespace {

constexpr double kPeriod = 0.1;

void expect_limits_kept(const Drive& result, const Limits& limits) {
  Twist2 last;
  for (const Twist2& t : result.twists) {
    EXPECT_LE(t.v, limits.v_max + 1e-9);
    EXPECT_GE(t.v, -limits.v_back_max - 1e-9);
    EXPECT_LE(std::abs(t.omega), limits.omega_max + 1e-9);
    // Braking, forward or backward, may use the deceleration of a stop.
    EXPECT_LE(t.v - last.v, (last.v < 0.0 ? limits.stop_deceleration : limits.acc_max) * kPeriod + 1e-9);
    EXPECT_GE(t.v - last.v, -(last.v > 0.0 ? limits.stop_deceleration : limits.acc_max) * kPeriod - 1e-9);
    EXPECT_LE(std::abs(t.omega - last.omega), limits.alpha_max * kPeriod + 1e-9);
    last = t;
  }
}

TEST(BandPlanner, ArrivesAtRestAndStaysThere) {
  BandPlanner planner({});
  for (const Pose2& goal :
       {Pose2{4, 0, 0}, Pose2{3, 2, 1.5}, Pose2{2, -1, -2.0}, Pose2{-2, 0.5, 3.0}, Pose2{0.3, 0, 0}}) {
    planner.reset();
    const PlanningProblem problem = problem_to(goal);
    const Drive result = drive(planner, problem, 300);
    const Pose2& end = result.poses.back();
    EXPECT_LE((end.position() - goal.position()).norm(), 0.1) << goal.x << " " << goal.y;
    EXPECT_LE(std::abs(wrap_angle(end.theta - goal.theta)), 0.12) << goal.x << " " << goal.y;
    EXPECT_EQ(result.twists.back(), Twist2{});
    EXPECT_EQ(result.poses[250], end) << "no dithering";
    expect_limits_kept(result, problem.limits);
  }
}

TEST(BandPlanner, StraightDriveTakesAboutTheTimeTheLimitsAllow) {
  // 8 m at 1 m/s and 1 m/s^2: 8 + 1 s; the penalty margins of speed and acceleration cost up to 15 %.
  BandPlanner planner({});
  const Drive result = drive(planner, problem_to({8, 0, 0}), 150);
  const auto arrived =
      std::find_if(result.poses.begin(), result.poses.end(), [](const Pose2& p) { return p.x > 7.9; });
  ASSERT_NE(arrived, result.poses.end());
  EXPECT_LE(kPeriod * static_cast<double>(arrived - result.poses.begin()), 9.0 * 1.15);
}

TEST(BandPlanner, GoesAroundStaticObstacles) {
  BandPlanner planner({});
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.discs = {{{3.0, 0.1}, 0.3}};
  problem.obstacles.points = {{5.0, -0.2}, {5.1, -0.3}};
  problem.obstacles.segments = {{{0.0, 2.0}, {8.0, 2.0}}};
  const Drive result = drive(planner, problem, 250);
  EXPECT_GT(result.smallest_gap, 0.1);
  EXPECT_LE((result.poses.back().position() - Vector2(8, 0)).norm(), 0.1);
  expect_limits_kept(result, problem.limits);
}

TEST(BandPlanner, PassesCrossingWalkers) {
  BandPlanner planner({});
  PlanningProblem problem = problem_to({8, 0, 0});
  for (int i = 0; i < 3; ++i) {
    Mover m;
    m.id = static_cast<std::uint32_t>(i);
    m.position = {2.5 + 2.0 * i, -2.6 - 1.9 * i};
    m.velocity = {0.0, 1.0};
    problem.movers.push_back(m);
  }
  const Drive result = drive(planner, problem, 250);
  EXPECT_GT(result.smallest_gap, 0.05);
  EXPECT_LE((result.poses.back().position() - Vector2(8, 0)).norm(), 0.1);
  expect_limits_kept(result, problem.limits);
}

// Once nobody is in the way any more the robot drives as gently as before: a step of the acceleration is at
// most jerk_max times the period.
TEST(BandPlanner, DrivesGentlyAgainAfterAnEvasion) {
  BandPlanner planner({});
  PlanningProblem problem = problem_to({12.0, 0.0, 0.0});
  const double most = problem.limits.jerk_max * problem.control_period;
  double acceleration = 0.0;
  int sharp_while_near = 0;
  int sharp_later = 0;
  for (int cycle = 0; cycle < 300; ++cycle) {
    if (cycle == 20) {
      const Vector2 beside = problem.pose.position() + Vector2(0.9, -0.3);
      problem.movers = {{.id = 1, .position = beside, .velocity = {0.0, 0.6}}};
    }
    if (cycle == 34) problem.movers.clear();
    const Drive step = drive(planner, problem, 1);
    const double next = (step.twists[0].v - problem.twist.v) / problem.control_period;
    const bool is_sharp = std::abs(next - acceleration) > most + 1e-6;
    if (is_sharp && cycle <= 36) ++sharp_while_near;
    if (is_sharp && cycle > 36 && step.poses[0].x < 10.0) ++sharp_later;  // the goal has rules of its own
    acceleration = next;
    problem.twist = step.twists[0];
    problem.pose = step.poses[0];
    problem.now = problem.now + Duration::seconds(problem.control_period);
    for (Mover& m : problem.movers) m.position += problem.control_period * m.velocity;
  }
  EXPECT_GT(sharp_while_near, 0) << "no evasion: the test says nothing";
  EXPECT_EQ(sharp_later, 0);
  EXPECT_LT((problem.pose.position() - Vector2(12.0, 0.0)).norm(), 0.2);
}

TEST(BandPlanner, StopsWithinLimitsInFrontOfAClosedWall) {
  BandPlanner planner({});
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.segments = {
      {{3.0, -4.0}, {3.0, 4.0}}, {{-2.0, -4.0}, {3.0, -4.0}}, {{-2.0, 4.0}, {3.0, 4.0}}};
  const Drive result = drive(planner, problem, 200);
  EXPECT_GT(result.smallest_gap, 0.0);
  expect_limits_kept(result, problem.limits);
  double late_travel = 0.0;
  for (std::size_t i = 150; i < result.twists.size(); ++i)
    late_travel += kPeriod * std::abs(result.twists[i].v);
  EXPECT_LT(late_travel, 0.2) << "stands in front of it instead of pacing";
}

TEST(BandPlanner, TypedStatusAndStopOnBadInput) {
  PlanningProblem good = problem_to({4, 0, 0});
  good.twist = {0.5, 0.2};
  const double bad = std::nan("");
  std::vector<PlanningProblem> problems(8, good);
  problems[0].pose.x = bad;
  problems[1].twist.omega = bad;
  problems[2].plan[1].theta = INFINITY;
  problems[3].obstacles.points = {{bad, 0.0}};
  problems[4].obstacles.discs = {{{0.0, 0.0}, -1.0}};
  problems[5].movers.resize(1);
  problems[5].movers[0].velocity.x() = 1e300;
  problems[6].footprint.radius = -0.1;
  problems[7].limits.v_max = 0.0;
  for (const PlanningProblem& problem : problems) {
    BandPlanner planner({});
    const PlanningResult result = planner.plan(problem);
    EXPECT_EQ(result.status, PlanningStatus::bad_input);
    EXPECT_FALSE(result.reason.empty());
    EXPECT_TRUE(is_finite(result.command));
    EXPECT_LT(result.command.v, 0.5);
  }
}

TEST(BandPlanner, NoPlanIsAStop) {
  BandPlanner planner({});
  PlanningProblem problem = problem_to({4, 0, 0});
  problem.plan.clear();
  problem.twist = {0.5, 0.0};
  const PlanningResult result = planner.plan(problem);
  EXPECT_EQ(result.status, PlanningStatus::no_plan);
  EXPECT_NEAR(result.command.v, 0.3, 1e-12) << "0.5 m/s less 2 m/s^2 over 0.1 s";
}

TEST(BandPlanner, StandsStillInsideAnObstacleItCannotLeave) {
  BandPlanner planner({});
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.discs = {{{0.0, 0.0}, 3.0}};
  const PlanningResult result = planner.plan(problem);
  EXPECT_EQ(result.status, PlanningStatus::infeasible);
  EXPECT_EQ(result.command, Twist2{});
}

TEST(BandPlanner, SameInputSameCommands) {
  PlanningProblem problem = problem_to({8, 1, 0});
  problem.obstacles.discs = {{{3.0, 0.1}, 0.3}, {{5.0, 0.7}, 0.3}};
  BandPlanner first({}), second({});
  const Drive a = drive(first, problem, 100);
  const Drive b = drive(second, problem, 100);
  EXPECT_EQ(a.poses, b.poses);
  EXPECT_EQ(a.twists, b.twists);
}

TEST(BandPlanner, MirroredSceneGivesMirroredCommands) {
  PlanningProblem problem = problem_to({6, 1, 0.4});
  problem.obstacles.discs = {{{2.0, 0.1}, 0.3}, {{4.0, 0.9}, 0.2}};
  PlanningProblem mirrored = problem;
  mirrored.plan[1] = {6, -1, -0.4};
  for (Disc& d : mirrored.obstacles.discs) d.center.y() = -d.center.y();
  BandPlanner left({}), right({});
  const PlanningResult a = left.plan(problem);
  const PlanningResult b = right.plan(mirrored);
  EXPECT_NEAR(a.command.v, b.command.v, 1e-6);
  EXPECT_NEAR(a.command.omega, -b.command.omega, 1e-6);
}

TEST(BandPlanner, FollowsARollingGoalAtSpeed) {
  // The local goal is not the end of the journey: no slowing down towards it.
  BandPlanner planner({});
  PlanningProblem problem = problem_to({4, 0, 0});
  problem.goal_is_final = false;
  double v = 0.0;
  for (int i = 0; i < 60; ++i) {
    problem.plan = {{-1, 0, 0}, {problem.pose.x + 4.0, 0, 0}};
    const PlanningResult result = planner.plan(problem);
    problem.twist = result.command;
    problem.pose = advance_exact(problem.pose, result.command, kPeriod);
    problem.now = problem.now + Duration::seconds(kPeriod);
    v = result.command.v;
  }
  EXPECT_GT(v, 0.9);
}

}  // namespace
}  // namespace bw::teb
