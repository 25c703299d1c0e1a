#include "components/local_planner/mppi/mppi_planner.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/components/local_planner/planner_drive.hpp"
#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw::mppi {
namespace {

MppiPlanner planner_with(const MppiOptions& options) { return MppiPlanner(options, {}); }

// The path is 5 m and 1 rad to rotate: 30 s is six times what it takes at 1 m/s.
TEST(MppiPlanner, ArrivesInTheOpen) {
  for (const Pose2& goal : {Pose2{5.0, 0.0, 0.0}, Pose2{3.0, 2.0, 1.0}, Pose2{-2.0, 1.0, 2.0}}) {
    MppiPlanner planner = planner_with({});
    const Drive drive = bw::drive(planner, problem_to(goal), 300);
    EXPECT_TRUE(is_at_rest_at(goal, drive)) << drive.poses.back().x << " " << drive.poses.back().y;
    const Limits limits;
    for (std::size_t i = 0; i < drive.twists.size(); ++i) {
      const Twist2 before = i == 0 ? Twist2{} : drive.twists[i - 1];
      ASSERT_LE(std::abs(drive.twists[i].v - before.v), 0.1 * limits.acc_max + 1e-9) << i;
      ASSERT_LE(std::abs(drive.twists[i].omega - before.omega), 0.1 * limits.alpha_max + 1e-9) << i;
    }
  }
}

// Where path_follow and the deviation cost balance (mppi/theory.md 5.8): 5 0.05 (0.2)^2 / 0.015 = 2/3 m/s,
// although 1 m/s is allowed.
TEST(MppiPlanner, DrivesAsFastAsItsWeightsBalance) {
  MppiPlanner planner = planner_with({});
  const Drive drive = bw::drive(planner, problem_to({40.0, 0.0, 0.0}), 120);
  double mean = 0.0;
  for (std::size_t i = 100; i < 120; ++i) mean += drive.twists[i].v / 20.0;
  EXPECT_NEAR(mean, 2.0 / 3.0, 0.05);
}

// A wall across the path with a gap of 1.4 m, through which the plan leads.
TEST(MppiPlanner, DrivesThroughAGapInAWall) {
  PlanningProblem problem = problem_to({4.0, 0.0, 0.0});
  problem.plan = {{0, 0, 0}, {1.2, 1.0, 0}, {2.8, 1.0, 0}, {4.0, 0.0, 0.0}};
  problem.obstacles.segments = {{{2.0, -3.0}, {2.0, 0.3}}, {{2.0, 1.7}, {2.0, 4.0}}};
  MppiPlanner planner = planner_with({});
  const Drive drive = bw::drive(planner, problem, 400);
  EXPECT_TRUE(is_at_rest_at({4.0, 0.0, 0.0}, drive)) << drive.poses.back().x << " " << drive.poses.back().y;
  EXPECT_GT(drive.smallest_gap, 0.0);
}

// Closed: it stops before it and touches nothing.
TEST(MppiPlanner, StopsBeforeAWall) {
  PlanningProblem problem = problem_to({4.0, 0.0, 0.0});
  problem.obstacles.segments = {{{2.0, -9.0}, {2.0, 9.0}}};
  MppiPlanner planner = planner_with({});
  const Drive drive = bw::drive(planner, problem, 200);
  EXPECT_GT(drive.smallest_gap, 0.0);
  EXPECT_LT(drive.poses.back().x, 1.7);
}

// Cycle by cycle: sums are taken in the same order, signs change no digit.
TEST(MppiPlanner, DrivesAMirroredSceneMirrored) {
  Random random(9);
  for (int i = 0; i < 4; ++i) {
    PlanningProblem scene = random_scene(random);
    PlanningProblem mirror = mirrored(scene);
    MppiPlanner one = planner_with({}), other = planner_with({});
    for (int cycle = 0; cycle < 10; ++cycle) {
      const Twist2 command = one.plan(scene).command;
      const Twist2 there = other.plan(mirror).command;
      ASSERT_NEAR(command.v, there.v, 1e-6) << i << " " << cycle;
      ASSERT_NEAR(command.omega, -there.omega, 1e-6) << i << " " << cycle;
      advance_scene(scene, command);
      advance_scene(mirror, {command.v, -command.omega});
    }
  }
}

TEST(MppiPlanner, RepeatsADriveToTheLastBitAndAnotherSeedDoesNot) {
  Random random(10);
  const PlanningProblem scene = random_scene(random);
  MppiOptions other_seed;
  other_seed.seed = 2;
  MppiPlanner one = planner_with({}), same = planner_with({}), other = planner_with(other_seed);
  const Drive drive = bw::drive(one, scene, 20), again = bw::drive(same, scene, 20);
  EXPECT_EQ(drive.twists, again.twists);
  EXPECT_NE(drive.twists, bw::drive(other, scene, 20).twists);
}

// Somebody comes from the right and will be on the way in 1.5 s; nobody is near now. As shipped that is as if
// nobody were there; looking ahead, the robot stays back. The first samples are those around standing.
TEST(MppiPlanner, LooksAheadOnRequest) {
  MppiOptions ahead;
  ahead.predict_movers = true;
  PlanningProblem without =
      problem_to({6.0, 0.01, 0.0});  // not straight on: samples are rotated alike without movers
  without.twist = {0.8, 0.0};
  PlanningProblem with = without;
  with.movers = {{.id = 1, .position = {1.0, -1.5}, .velocity = {0.0, 1.0}}};
  MppiPlanner alone = planner_with({}), shipped = planner_with({}), predicting = planner_with(ahead);
  const auto end_of = [](const PlanningResult& result) { return result.trajectory.back().pose.position(); };
  const PlanningResult free = alone.plan(without), unaware = shipped.plan(with),
                       aware = predicting.plan(with);
  ASSERT_EQ(free.status, PlanningStatus::ok);
  ASSERT_EQ(unaware.status, PlanningStatus::ok);
  ASSERT_EQ(aware.status, PlanningStatus::ok);
  EXPECT_EQ(end_of(unaware), end_of(free));
  EXPECT_LT(end_of(aware).x(), end_of(free).x() - 0.1);
}

// Somebody walks into the robot from ahead. As shipped it stops when every sample collides; with the layer of
// the other planners it has been out of the way by then.
TEST(MppiPlanner, GetsOutOfTheWayOnRequest) {
  PlanningProblem problem = problem_to({6.0, 0.0, 0.0});
  problem.movers = {{.id = 1, .position = {3.0, 0.05}, .velocity = {-0.8, 0.0}}};
  MppiOptions checked;
  checked.check_motion = true;
  MppiPlanner shipped = planner_with({}), evading = planner_with(checked);
  const Drive plain = bw::drive(shipped, problem, 60), layered = bw::drive(evading, problem, 60);
  EXPECT_TRUE(std::count(plain.statuses.begin(), plain.statuses.end(), PlanningStatus::infeasible) > 0 ||
              plain.smallest_gap > 0.0);
  EXPECT_GT(layered.smallest_gap, 0.0);
}

TEST(MppiPlanner, ShowsTheMeanAndTheBestSamples) {
  MppiPlanner planner = planner_with({});
  const PlanningResult result = planner.plan(problem_to({5, 0, 0}));
  ASSERT_EQ(result.candidates.size(), 6U);
  EXPECT_TRUE(result.candidates[0].chosen);
  EXPECT_EQ(result.candidates[0].label, "mean");
  for (std::size_t i = 2; i < 6; ++i) {
    EXPECT_FALSE(result.candidates[i].chosen);
    EXPECT_GE(result.candidates[i].cost, result.candidates[i - 1].cost);
  }
  ASSERT_EQ(result.trajectory.size(), 57U);
  EXPECT_NEAR(result.trajectory.back().time, 2.8, 1e-12);
}

}  // namespace
}  // namespace bw::mppi
