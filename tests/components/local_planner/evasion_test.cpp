#include "components/local_planner/evasion.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bw {
namespace {

PlanningProblem driving_at(double v) {
  PlanningProblem problem;
  problem.twist = {v, 0.0};
  return problem;
}

TEST(Evasion, StopsWhenAStopIsSafe) {
  const EvasiveMove move = best_evasive_move(driving_at(0.5), {10.0, 0.0}, {});
  EXPECT_NEAR(move.trajectory[1].twist.v, 0.3, 1e-12);
  EXPECT_NEAR(move.trajectory[1].twist.omega, 0.0, 1e-12);
}

TEST(Evasion, BacksAwayFromAWallAndAnApproachingMover) {
  // A corridor 0.8 m wide with somebody coming at 0.3 m/s: backward is the only way out.
  PlanningProblem problem = driving_at(0.0);
  problem.limits.v_back_max = 0.4;
  problem.obstacles.segments = {{{-9.0, 0.4}, {9.0, 0.4}}, {{-9.0, -0.4}, {9.0, -0.4}}};
  Mover mover;
  mover.position = {1.0, 0.0};
  mover.velocity = {-0.3, 0.0};
  problem.movers = {mover};
  const EvasiveMove move = best_evasive_move(problem, {10.0, 0.0}, {});
  EXPECT_LT(move.trajectory[1].twist.v, 0.0);
  EXPECT_GT(move.gap, 0.0);
}

TEST(Evasion, KeepsAccelerationLimits) {
  PlanningProblem problem = driving_at(0.8);
  problem.obstacles.segments = {{{1.0, -3.0}, {1.0, 3.0}}};
  const EvasiveMove move = best_evasive_move(problem, {10.0, 0.0}, {});
  for (std::size_t i = 1; i < move.trajectory.size(); ++i) {
    const double dv = move.trajectory[i].twist.v - move.trajectory[i - 1].twist.v;
    EXPECT_LE(dv, problem.limits.acc_max * 0.1 + 1e-12);
    EXPECT_GE(dv, -problem.limits.stop_deceleration * 0.1 - 1e-12);
    EXPECT_LE(std::abs(move.trajectory[i].twist.omega - move.trajectory[i - 1].twist.omega),
              problem.limits.alpha_max * 0.1 + 1e-12);
  }
}

// Somebody overtakes the robot 5 cm beside it: nearer than asked at time 0, and going away. To drive on is as
// clear as a stop, and leads to the goal.
TEST(Evasion, DrivesOnBesideWhoIsNearAndGoesAway) {
  PlanningProblem problem = driving_at(0.5);
  Mover mover;
  mover.position = {0.0, 0.65};
  mover.velocity = {1.2, 0.2};
  problem.movers = {mover};
  EvasionOptions options;
  options.asked_gap = 0.1;
  const EvasiveMove move = best_evasive_move(problem, {10.0, 0.0}, options);
  EXPECT_TRUE(std::isinf(move.contact_time));
  EXPECT_GT(move.trajectory[1].twist.v, 0.5);
}

// Somebody who walks faster than the robot has run into it from behind. To drive on takes it out of the way;
// a stop, or to stand as if every motion were a contact, leaves it under their feet.
TEST(Evasion, DrivesAwayFromWhoTouchesItFromBehind) {
  for (const double speed : {0.0, 0.5}) {
    for (const double gap : {-0.05, -0.005}) {
      PlanningProblem problem = driving_at(speed);
      Mover mover;
      mover.position = {-0.6 - gap, 0.0};
      mover.velocity = {0.8, 0.0};
      problem.movers = {mover};
      const EvasiveMove move = best_evasive_move(problem, {10.0, 0.0}, {});
      EXPECT_GT(move.trajectory[1].twist.v, speed) << "gap " << gap;
    }
  }
}

Mover walker(const Vector2& position, const Vector2& velocity) {
  Mover mover;
  mover.position = position;
  mover.velocity = velocity;
  return mover;
}

// A group of three, 0.7 m beside each other, overtakes the robot. None of its moves stays clear. To run
// before them puts the contact off, in the middle of their way; to the side it can at least get out from
// before the middle one.
TEST(Evasion, LeavesTheWayOfAGroupRatherThanRunBeforeIt) {
  PlanningProblem problem = driving_at(1.0);
  for (const double aside : {-0.7, 0.0, 0.7})
    problem.movers.push_back(walker({-0.9, aside + 0.15}, {1.6, 0.0}));
  const EvasiveMove move = best_evasive_move(problem, {10.0, 0.0}, {});
  EXPECT_FALSE(std::isinf(move.contact_time));
  EXPECT_GT(std::abs(move.trajectory[1].twist.omega), 0.1);
}

// Between one who comes from behind and one who stands ahead no move is clear; none that is taken drives into
// the one ahead.
TEST(Evasion, RunsIntoNobodyToGetOutOfTheWayOfAnother) {
  PlanningProblem problem = driving_at(0.3);
  problem.obstacles.segments = {{{-9.0, 0.4}, {9.0, 0.4}}, {{-9.0, -0.4}, {9.0, -0.4}}};
  problem.movers = {walker({0.9, 0.0}, {0.0, 0.0}), walker({-0.9, 0.0}, {1.2, 0.0})};
  const EvasiveMove move = best_evasive_move(problem, {10.0, 0.0}, {});
  for (const TrajectoryPoint& point : move.trajectory) {
    const double gap = 0.9 - point.pose.x - 0.6;
    EXPECT_TRUE(gap >= 0.0 || point.twist.v <= 0.2) << "at " << point.time << " s";
  }
}

}  // namespace
}  // namespace bw
