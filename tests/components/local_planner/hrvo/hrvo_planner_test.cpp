// The planner in closed loop with an ideal unicycle that takes its commands as they are.
#include "components/local_planner/hrvo/hrvo_planner.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "components/local_planner/footprint_check.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"
#include "tests/components/local_planner/planner_drive.hpp"

namespace bw::hrvo {
namespace {

constexpr double kPeriod = 0.1;

Mover mover(const Vector2& position, const Vector2& velocity) {
  Mover m;
  m.position = position;
  m.velocity = velocity;
  return m;
}

void advance(PlanningProblem& problem, const Twist2& command) {
  problem.twist = command;
  problem.pose = advance_exact(problem.pose, command, kPeriod);
  problem.now = problem.now + Duration::seconds(kPeriod);
}

Drive drive(const PlanningProblem& problem, int cycles) {
  HrvoPlanner planner({}, {});
  return bw::drive(planner, problem, cycles);
}

void expect_at(const Drive& result, const Vector2& goal) {
  EXPECT_LE((result.poses.back().position() - goal).norm(), 0.1) << goal.x() << " " << goal.y();
  EXPECT_EQ(result.twists.back(), Twist2{});
}

void expect_limits_kept(const Drive& result, const Limits& limits) {
  Twist2 last;
  for (const Twist2& t : result.twists) {
    EXPECT_LE(t.v, limits.v_max + 1e-9);
    EXPECT_GE(t.v, -limits.v_back_max - 1e-9);
    EXPECT_LE(std::abs(t.omega), limits.omega_max + 1e-9);
    // An evasion may brake with the deceleration of a stop.
    EXPECT_LE(std::abs(t.v) - std::abs(last.v), limits.acc_max * kPeriod + 1e-9);
    EXPECT_LE(std::abs(t.v - last.v), limits.stop_deceleration * kPeriod + 1e-9);
    EXPECT_LE(std::abs(t.omega - last.omega), limits.alpha_max * kPeriod + 1e-9);
    last = t;
  }
}

TEST(HrvoPlanner, ArrivesAtRestAndStaysThere) {
  for (const Pose2& goal :
       {Pose2{4, 0, 0}, Pose2{3, 2, 1.5}, Pose2{2, -1, -2.0}, Pose2{-2, 0.5, 3.0}, Pose2{0.3, 0, 0}}) {
    const PlanningProblem problem = problem_to(goal);
    const Drive result = drive(problem, 250);
    expect_at(result, goal.position());
    EXPECT_LE(std::abs(wrap_angle(result.poses.back().theta - goal.theta)), 0.12);
    EXPECT_EQ(result.poses[200], result.poses.back()) << "no dithering";
    expect_limits_kept(result, problem.limits);
  }
}

TEST(HrvoPlanner, StraightDriveTakesAboutTheTimeTheLimitsAllow) {
  // 8 m at 1 m/s and 1 m/s^2: 9 s to rest; the last 0.1 m belong to the arrival.
  const Drive result = drive(problem_to({8, 0, 0}), 100);
  const auto arrived =
      std::find_if(result.poses.begin(), result.poses.end(), [](const Pose2& p) { return p.x > 7.9; });
  ASSERT_NE(arrived, result.poses.end());
  EXPECT_LE(kPeriod * static_cast<double>(arrived - result.poses.begin()), 9.0 * 1.05);
}

TEST(HrvoPlanner, GoesAroundStaticObstacles) {
  PlanningProblem problem = problem_to({9, 0, 0});
  problem.obstacles.discs = {{{3.0, 0.1}, 0.3}};
  problem.obstacles.points = {{5.5, -0.2}, {5.6, -0.3}};
  problem.obstacles.segments = {{{0.0, 2.0}, {9.0, 2.0}}};
  const Drive result = drive(problem, 200);
  EXPECT_GT(result.smallest_gap, 0.1) << "margin 0.2 m, less what turning takes";
  expect_at(result, {9, 0});
  expect_limits_kept(result, problem.limits);
}

TEST(HrvoPlanner, DrivesThroughADoorAndStopsBeforeTheWallBehindIt) {
  PlanningProblem problem = problem_to({6.6, 0, 0});
  problem.obstacles.segments = {
      {{3.0, 0.6}, {3.0, 4.0}}, {{3.0, -4.0}, {3.0, -0.6}}, {{7.0, -4.0}, {7.0, 4.0}}};
  const Drive result = drive(problem, 200);
  EXPECT_GT(result.smallest_gap, 0.0);
  expect_at(result, {6.6, 0});
}

TEST(HrvoPlanner, PassesSomebodyWhoComesHeadOnWithoutYielding) {
  for (const double offset : {0.0, 0.3, -0.3}) {
    PlanningProblem problem = problem_to({10, 0, 0});
    problem.movers = {mover({9.0, offset}, {-1.0, 0.0})};
    const Drive result = drive(problem, 200);
    EXPECT_GT(result.smallest_gap, 0.1) << offset;
    expect_at(result, {10, 0});
    expect_limits_kept(result, problem.limits);
    const auto passing =
        std::find_if(result.poses.begin(), result.poses.end(), [](const Pose2& p) { return p.x > 4.5; });
    ASSERT_NE(passing, result.poses.end());
    EXPECT_EQ(passing->y < offset, offset >= 0.0) << "on the side where the way is; straight ahead: right";
  }
}

TEST(HrvoPlanner, PassesSomebodyInACorridorTooNarrowForTheMargin) {
  // 2 m wide, somebody 0.1 m left of its middle: 0.9 + 0.1 - 0.3 m are left for a robot of 0.6 m, not for the
  // 0.8 m (and 0.2 m more to the wall) that the whole margin asks for.
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.segments = {{{-5.0, 1.0}, {20.0, 1.0}}, {{-5.0, -1.0}, {20.0, -1.0}}};
  problem.movers = {mover({7.0, 0.1}, {-0.5, 0.0})};
  const Drive result = drive(problem, 200);
  EXPECT_GT(result.smallest_gap, 0.0);
  expect_at(result, {8, 0});
  EXPECT_GT(std::min_element(result.poses.begin(), result.poses.end(),
                             [](const Pose2& a, const Pose2& b) { return a.x < b.x; })
                ->x,
            -0.05)
      << "does not flee";
}

TEST(HrvoPlanner, StandsWhereNothingLeadsOn) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.segments = {
      {{3.0, -4.0}, {3.0, 4.0}}, {{-2.0, -4.0}, {3.0, -4.0}}, {{-2.0, 4.0}, {3.0, 4.0}}};
  HrvoPlanner planner({}, {});
  PlanningResult result;
  double late_travel = 0.0;
  for (int i = 0; i < 300; ++i) {
    result = planner.plan(problem);
    advance(problem, result.command);
    if (i > 200) late_travel += kPeriod * std::abs(result.command.v);
  }
  EXPECT_EQ(result.status, PlanningStatus::infeasible) << "so that the navigator hears of it";
  EXPECT_EQ(result.command, Twist2{});
  EXPECT_LT(late_travel, 0.05);
}

TEST(HrvoPlanner, TwoOfThemShareTheWayRound) {
  PlanningProblem east = problem_to({10, 0, 0});
  PlanningProblem west = problem_to({0, 0, M_PI});
  west.pose = {10, 0, M_PI};
  west.plan.front() = west.pose;
  HrvoPlanner driver({}, {}), other_driver({}, {});
  const auto seen = [](const PlanningProblem& p) {
    Mover m = mover(p.pose.position(), p.twist.v * direction(p.pose.theta));
    m.reciprocal = true;
    return m;
  };
  double smallest_gap = 1e9, east_y = 0.0, west_y = 0.0;
  for (int i = 0; i < 180; ++i) {
    east.movers = {seen(west)};
    west.movers = {seen(east)};
    const Twist2 go_east = driver.plan(east).command;
    advance(west, other_driver.plan(west).command);
    advance(east, go_east);
    smallest_gap = std::min(smallest_gap, (east.pose.position() - west.pose.position()).norm() - 0.6);
    east_y = std::min(east_y, east.pose.y);
    west_y = std::max(west_y, west.pose.y);
  }
  EXPECT_GT(smallest_gap, 0.1);
  EXPECT_NEAR(east_y, -west_y, 1e-6) << "each does half, both keep right";
  EXPECT_LE((east.pose.position() - Vector2(10, 0)).norm(), 0.1);
  EXPECT_LE((west.pose.position() - Vector2(0, 0)).norm(), 0.1);
}

TEST(HrvoPlanner, StopsWithinLimitsInFrontOfAClosedWall) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.segments = {
      {{3.0, -4.0}, {3.0, 4.0}}, {{-2.0, -4.0}, {3.0, -4.0}}, {{-2.0, 4.0}, {3.0, 4.0}}};
  const Drive result = drive(problem, 300);
  EXPECT_GT(result.smallest_gap, 0.0);
  expect_limits_kept(result, problem.limits);
}

TEST(HrvoPlanner, TellsWhatItLookedAt) {
  HrvoPlanner planner({}, {});
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.movers = {mover({4.0, 0.1}, {-0.5, 0.0}), mover({4.0, 3.0}, {0.0, -0.5})};
  const PlanningResult result = planner.plan(problem);
  EXPECT_EQ(result.status, PlanningStatus::ok);
  EXPECT_EQ(result.velocity_cones.size(), 2U);
  ASSERT_TRUE(result.velocity_wanted.has_value());
  EXPECT_LT(result.velocity_wanted->y(), 0.0);
  ASSERT_FALSE(result.candidates.empty());
  EXPECT_TRUE(result.candidates.back().chosen);
  EXPECT_EQ(result.trajectory[1].twist, result.command);
}

TEST(HrvoPlanner, TypedStatusAndStopOnBadInput) {
  PlanningProblem good = problem_to({4, 0, 0});
  good.twist = {0.5, 0.2};
  const double bad = std::nan("");
  std::vector<PlanningProblem> problems(6, good);
  problems[0].pose.x = bad;
  problems[1].twist.omega = bad;
  problems[2].plan[1].theta = INFINITY;
  problems[3].obstacles.points = {{bad, 0.0}};
  problems[4].movers = {mover({1.0, 0.0}, {bad, 0.0})};
  problems[5].limits.v_max = 0.0;
  for (const PlanningProblem& problem : problems) {
    HrvoPlanner planner({}, {});
    const PlanningResult result = planner.plan(problem);
    EXPECT_EQ(result.status, PlanningStatus::bad_input);
    EXPECT_FALSE(result.reason.empty());
    EXPECT_TRUE(is_finite(result.command));
    EXPECT_LT(result.command.v, 0.5);
  }
  HrvoPlanner planner({}, {});
  good.plan.clear();
  EXPECT_EQ(planner.plan(good).status, PlanningStatus::no_plan);
}

TEST(HrvoPlanner, FiniteCommandsInAbsurdScenes) {
  Random random(10);
  HrvoPlanner planner({}, {});
  for (int i = 0; i < 1000; ++i) {
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

TEST(HrvoPlanner, SameInputSameCommands) {
  PlanningProblem problem = problem_to({8, 1, 0});
  problem.obstacles.discs = {{{3.0, 0.1}, 0.3}, {{5.0, 0.7}, 0.3}};
  problem.movers = {mover({6.0, -2.0}, {-0.3, 0.6})};
  const Drive a = drive(problem, 120);
  const Drive b = drive(problem, 120);
  EXPECT_EQ(a.poses, b.poses);
  EXPECT_EQ(a.twists, b.twists);
}

TEST(HrvoPlanner, MirroredSceneGivesMirroredDrive) {
  PlanningProblem problem = problem_to({6, 1, 0.4});
  problem.obstacles.discs = {{{2.0, 0.1}, 0.3}, {{4.0, 0.9}, 0.2}};
  problem.movers = {mover({5.0, -2.0}, {-0.3, 0.6})};
  PlanningProblem mirrored = problem;
  mirrored.plan[1] = {6, -1, -0.4};
  for (Disc& d : mirrored.obstacles.discs) d.center.y() = -d.center.y();
  mirrored.movers = {mover({5.0, 2.0}, {-0.3, -0.6})};
  const Drive left = drive(problem, 100);
  const Drive right = drive(mirrored, 100);
  for (std::size_t i = 0; i < left.poses.size(); ++i) {
    ASSERT_NEAR(left.poses[i].x, right.poses[i].x, 1e-6) << i;
    ASSERT_NEAR(left.poses[i].y, -right.poses[i].y, 1e-6) << i;
  }
}

}  // namespace
}  // namespace bw::hrvo
