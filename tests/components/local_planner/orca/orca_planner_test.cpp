// The planner in closed loop with an ideal unicycle that takes its commands as they are.
#include "components/local_planner/orca/orca_planner.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/local_planner/planner_drive.hpp"

namespace bw::orca {
namespace {

Mover mover(const Vector2& position, const Vector2& velocity) {
  Mover m;
  m.position = position;
  m.velocity = velocity;
  return m;
}

Drive drive(const PlanningProblem& problem, int cycles, const OrcaOptions& options = {}) {
  OrcaPlanner planner(options, {});
  return bw::drive(planner, problem, cycles);
}

void expect_at(const Drive& result, const Vector2& goal) {
  EXPECT_LE((result.poses.back().position() - goal).norm(), 0.1) << goal.x() << " " << goal.y();
  EXPECT_EQ(result.twists.back(), Twist2{});
}

TEST(OrcaPlanner, ArrivesAtRest) {
  for (const Pose2& goal : {Pose2{4, 0, 0}, Pose2{3, 2, 1.5}, Pose2{2, -1, -2.0}, Pose2{-2, 0.5, 3.0}})
    expect_at(drive(problem_to(goal), 250), goal.position());
}

TEST(OrcaPlanner, StraightDriveTakesAboutTheTimeTheLimitsAllow) {
  // 8 m at 1 m/s and 1 m/s^2: 9 s to rest; the last 0.1 m belong to the arrival.
  const Drive result = drive(problem_to({8, 0, 0}), 100);
  const auto arrived =
      std::find_if(result.poses.begin(), result.poses.end(), [](const Pose2& p) { return p.x > 7.9; });
  ASSERT_NE(arrived, result.poses.end());
  EXPECT_LE(0.1 * static_cast<double>(arrived - result.poses.begin()), 9.0 * 1.05);
}

TEST(OrcaPlanner, GoesAroundStaticObstacles) {
  PlanningProblem problem = problem_to({9, 0, 0});
  problem.obstacles.discs = {{{3.0, 0.1}, 0.3}};
  problem.obstacles.points = {{5.5, -0.2}, {5.6, -0.3}};
  problem.obstacles.segments = {{{0.0, 2.0}, {9.0, 2.0}}};
  const Drive result = drive(problem, 200);
  EXPECT_GT(result.smallest_gap, 0.0);
  expect_at(result, {9, 0});
}

TEST(OrcaPlanner, DrivesThroughADoorAndStopsBeforeTheWallBehindIt) {
  PlanningProblem problem = problem_to({6.6, 0, 0});
  problem.obstacles.segments = {
      {{3.0, 0.6}, {3.0, 4.0}}, {{3.0, -4.0}, {3.0, -0.6}}, {{7.0, -4.0}, {7.0, 4.0}}};
  const Drive result = drive(problem, 200);
  EXPECT_GT(result.smallest_gap, 0.0);
  expect_at(result, {6.6, 0});
}

TEST(OrcaPlanner, PassesSomebodyWhoDoesNotReact) {
  for (const Mover& m : {mover({9.0, 0.0}, {-1.0, 0.0}), mover({9.0, 0.3}, {-1.0, 0.0}),
                         mover({5.0, -5.0}, {0.0, 0.9}), mover({4.0, 4.0}, {0.0, -0.9})}) {
    PlanningProblem problem = problem_to({10, 0, 0});
    problem.movers = {m};
    const Drive result = drive(problem, 220);
    EXPECT_GT(result.smallest_gap, 0.0) << m.position.transpose();
    expect_at(result, {10, 0});
  }
}

// Half of the way round is left to who is trusted to make the other half: at first sight the robot turns away
// less.
TEST(OrcaPlanner, LeavesHalfToWhoIsTrusted) {
  PlanningProblem problem = problem_to({10, 0, 0});
  problem.twist = {1.0, 0.0};
  problem.movers = {mover({5.0, 0.2}, {-1.0, 0.0})};
  const auto wanted = [&](hrvo::Reciprocity reciprocity) {
    OrcaPlanner planner({.reciprocity = reciprocity}, {});
    return *planner.plan(problem).velocity_wanted;
  };
  const Vector2 alone = wanted(hrvo::Reciprocity::known);
  const Vector2 shared = wanted(hrvo::Reciprocity::all);
  EXPECT_LT(alone.y(), 0.0) << "they are a bit to the left";
  EXPECT_LT(shared.y(), 0.0);
  EXPECT_LT(alone.y(), 1.5 * shared.y());
  problem.movers[0].reciprocal = true;
  EXPECT_EQ(wanted(hrvo::Reciprocity::known), shared);
}

TEST(OrcaPlanner, TellsWhatItLookedAt) {
  OrcaPlanner planner({}, {});
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.movers = {mover({4.0, 0.1}, {-0.5, 0.0}), mover({4.0, 3.0}, {0.0, -0.5})};
  problem.obstacles.discs = {{{1.5, -1.2}, 0.3}};
  const PlanningResult result = planner.plan(problem);
  EXPECT_EQ(result.status, PlanningStatus::ok);
  ASSERT_EQ(result.velocity_cones.size(), 3U);
  for (const VelocityCone& cone : result.velocity_cones) {
    EXPECT_TRUE(cone.left.isApprox(-cone.right)) << "half planes";
    const Vector2 from_apex = *result.velocity_wanted - cone.apex;
    EXPECT_FALSE(cross(cone.right, from_apex) > 1e-6 && cross(cone.left, from_apex) < -1e-6);
  }
  EXPECT_EQ(result.trajectory[1].twist, result.command);
}

TEST(OrcaPlanner, FiniteCommandsInAbsurdScenes) {
  Random random(10);
  OrcaPlanner planner({}, {});
  for (int i = 0; i < 100; ++i) {
    const auto size = [&] { return std::pow(10.0, random.uniform(-9.0, 5.9)); };
    PlanningProblem problem = problem_to({size(), -size(), 1.0});
    problem.twist = {size(), -size()};
    problem.limits.stop_deceleration = size();
    problem.limits.acc_max = size();
    problem.limits.v_max = size();
    problem.command_lead = i % 3 == 0 ? 0.0 : 0.1;
    problem.goal_is_final = i % 2 == 0;
    problem.movers = {mover({0.0, 0.0}, {0.0, 0.0}), mover({size(), 0.0}, {-size(), size()})};
    problem.obstacles.discs = {{{0.0, 0.0}, 0.0}, {{-size(), size()}, size()}};
    problem.obstacles.segments = {{{1.0, 1.0}, {1.0, 1.0}}, {{size(), 0.0}, {0.0, size()}}};
    ASSERT_TRUE(is_finite(planner.plan(problem).command)) << i;
  }
}

}  // namespace
}  // namespace bw::orca
