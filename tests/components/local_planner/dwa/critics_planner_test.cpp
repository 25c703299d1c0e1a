// DWA led by the plan, in closed loop with an ideal base.
#include "components/local_planner/dwa/critics_planner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/local_planner/planner_registry.hpp"
#include "components/model/random.hpp"
#include "tests/components/local_planner/planner_drive.hpp"
#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw::dwa {
namespace {

DrivingOptions no_evasion() {
  DrivingOptions options;
  options.evasion_horizon = 0.0;
  return options;
}

// 0.5 x 0.4 m.
Footprint box() { return {std::hypot(0.25, 0.2), {{0.25, 0.2}, {-0.25, 0.2}, {-0.25, -0.2}, {0.25, -0.2}}}; }

bool is_there(const Drive& drive, const Vector2& goal) {
  return (drive.poses.back().position() - goal).norm() <= 0.2;
}

TEST(CriticsPlanner, IsTheDefaultOfDwaAndEdwa) {
  for (const char* name : {"dwa", "edwa"}) {
    const auto planner = make_planner(name, {});
    EXPECT_NE(dynamic_cast<CriticsPlanner*>(planner.get()), nullptr) << name;
  }
}

TEST(CriticsPlanner, ArrivesAtRestAtTheGoalHeading) {
  for (const Pose2& goal :
       {Pose2{4, 0, 0}, Pose2{3, 2, 1.5}, Pose2{2, -1, -2.0}, Pose2{-2, 0.5, 3.0}, Pose2{0.3, 0, 0}}) {
    CriticsPlanner planner({}, {});
    EXPECT_TRUE(is_at_rest_at(goal, drive(planner, problem_to(goal), 400))) << goal.x << " " << goal.y;
  }
}

TEST(CriticsPlanner, DrivesStraightOnAsFastAsTheLimitsAllow) {
  // 8 m at 1 m/s and 1 m/s^2: 8 + 1 s to rest; 0.1 m before it about 8.6 s, braking 0.1 s early 0.1 s more.
  CriticsPlanner planner({}, {});
  const Drive result = drive(planner, problem_to({8, 0, 0}), 150);
  const auto arrived =
      std::find_if(result.poses.begin(), result.poses.end(), [](const Pose2& p) { return p.x > 7.9; });
  ASSERT_NE(arrived, result.poses.end());
  EXPECT_LE(0.1 * static_cast<double>(arrived - result.poses.begin()), 9.2);
  for (const Pose2& pose : result.poses) EXPECT_NEAR(pose.y, 0.0, 1e-3);
}

TEST(CriticsPlanner, AWallBesideThePlanIsNoReasonToLeaveIt) {
  // 5 cm beside the margin of the robot's side, for 6 m.
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.footprint = box();
  problem.obstacles.segments = {{{1.0, 0.3}, {7.0, 0.3}}};
  CriticsPlanner planner({}, {});
  const Drive result = drive(planner, problem, 150);
  EXPECT_TRUE(is_there(result, {8, 0}));
  EXPECT_GT(result.smallest_gap, 0.05);
  for (const Pose2& pose : result.poses) EXPECT_NEAR(pose.y, 0.0, 0.15);
  EXPECT_GT(std::max_element(result.twists.begin(), result.twists.end(),
                             [](const Twist2& a, const Twist2& b) { return a.v < b.v; })
                ->v,
            0.9);
}

TEST(CriticsPlanner, TheBodyPassesWhereItsDiscDoesNot) {
  // 0.6 m between two posts; the disc around the body needs 0.64 m, the body 0.4 m and twice the margin of
  // 0.05 m.
  PlanningProblem problem = problem_to({6, 0, 0});
  problem.footprint = box();
  problem.obstacles.discs = {{{3.0, 0.4}, 0.1}, {{3.0, -0.4}, 0.1}};
  CriticsPlanner planner({}, {});
  const Drive result = drive(planner, problem, 150);
  EXPECT_TRUE(is_there(result, {6, 0}));
  EXPECT_GT(result.smallest_gap, 0.0);
}

TEST(CriticsPlanner, FollowsThePlanOutOfWhatLooksLikeADeadEnd) {
  // A pocket 1.4 m wide ends at x = 4; 0.8 m before its end a gap of 0.8 m leads out to the left, and the
  // plan with it.
  PlanningProblem problem = problem_to({3.5, 3.0, 1.57});
  problem.footprint = box();
  problem.plan = {{0, 0, 0}, {3.5, 0, 0}, {3.5, 3.0, 1.57}};
  problem.obstacles.segments = {{{0.0, -0.7}, {4.0, -0.7}},
                                {{4.0, -0.7}, {4.0, 0.7}},
                                {{0.0, 0.7}, {3.1, 0.7}},
                                {{3.9, 0.7}, {4.0, 0.7}}};
  CriticsPlanner planner({}, {});
  const Drive result = drive(planner, problem, 300);
  EXPECT_TRUE(is_there(result, {3.5, 3.0}));
  EXPECT_GT(result.smallest_gap, 0.0);
}

TEST(CriticsPlanner, TurnsOnTheSpotWhenThePlanLeadsBack) {
  PlanningProblem problem = problem_to({-4, 0.5, 3.0});
  CriticsPlanner planner({}, {});
  const Drive result = drive(planner, problem, 200);
  EXPECT_TRUE(is_there(result, {-4, 0.5}));
  for (std::size_t i = 0; i < result.poses.size(); ++i) {
    EXPECT_LT(result.poses[i].x, 0.1) << "it does not drive an arc";
    EXPECT_TRUE(i >= 20 || result.twists[i].v < 1e-9) << i << ": 3 rad at 1 rad/s";
  }
}

TEST(CriticsPlanner, TurnsRoundWhereABoxIsTooLongToTurnToTheNearSide) {
  // Along a wall 0.22 m to its left, the plan back past the wall's end on that side: a box of 0.5 x 0.4 m
  // cannot rotate left.
  PlanningProblem problem = problem_to({-3, 0, 3.1});
  problem.footprint = box();
  problem.plan = {{0, 0, 0}, {-1, 0.05, 0}, {-3, 0, 3.1}};
  problem.obstacles.segments = {{{-0.4, 0.3}, {3.0, 0.3}}};
  CriticsPlanner planner({}, {});
  const Drive result = drive(planner, problem, 400);
  EXPECT_TRUE(is_there(result, {-3, 0}));
  EXPECT_GT(result.smallest_gap, 0.0);
}

TEST(CriticsPlanner, RecoversFromStandingBeforeAWall) {
  // 4 cm before a wall, the plan to the side: inside its margin, nothing that comes closer is admissible.
  PlanningProblem problem = problem_to({0, 4, 1.57});
  problem.footprint = box();
  problem.obstacles.segments = {{{0.29, -5.0}, {0.29, 5.0}}};
  CriticsPlanner planner({}, {});
  const Drive result = drive(planner, problem, 400);
  EXPECT_TRUE(is_there(result, {0, 4})) << result.poses.back().x << " " << result.poses.back().y;
  EXPECT_GT(result.smallest_gap, 0.0);
}

TEST(CriticsPlanner, GoesAroundWhatStandsOnThePlan) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.discs = {{{3.0, 0.15}, 0.3}};
  CriticsPlanner planner({}, {});
  const Drive result = drive(planner, problem, 200);
  EXPECT_TRUE(is_there(result, {8, 0}));
  EXPECT_GT(result.smallest_gap, 0.0);
}

TEST(CriticsPlanner, NothingAdmissibleBrakesAndReportsIt) {
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.twist = {1.0, 0.4};
  problem.obstacles.segments = {{{0.6, -5.0}, {0.6, 5.0}}};
  CriticsPlanner planner({}, no_evasion());
  const PlanningResult result = planner.plan(problem);
  EXPECT_EQ(result.status, PlanningStatus::infeasible);
  EXPECT_FALSE(result.reason.empty());
  EXPECT_NEAR(result.command.v, 0.8, 1e-12) << "stop_deceleration 2 m/s^2 over 0.1 s";
}

TEST(CriticsPlanner, EdwaIsDwaWhileNobodyCouldBeMet) {
  Random random(14);
  for (int i = 0; i < 50; ++i) {
    PlanningProblem problem = problem_to({8, random.uniform(-2, 2), 0});
    problem.twist = {random.uniform(0.0, 1.0), random.uniform(-0.5, 0.5)};
    const double x = random.uniform(1, 4);
    problem.obstacles.discs = {{{x, random.uniform(-2, 2)}, 0.2}};
    Mover far;
    far.position = {30.0, 0.0};
    problem.movers = {far};
    CriticsPlanner dwa({}, no_evasion());
    CriticsPlanner edwa({}, no_evasion(), EdwaOptions{}, {});
    EXPECT_EQ(dwa.plan(problem).command, edwa.plan(problem).command) << i;
    EXPECT_FALSE(edwa.plan(problem).velocity_wanted.has_value());
  }
}

TEST(CriticsPlanner, EdwaTurnsToTheSideOfHrvoWhenSomebodyComes) {
  PlanningProblem problem = problem_to({16, 0, 0});
  problem.twist = {0.8, 0.0};
  Mover m;
  m.position = {4.0, -0.2};
  m.velocity = {-0.8, 0.0};
  problem.movers = {m};
  CriticsPlanner edwa({}, no_evasion(), EdwaOptions{}, {});
  const PlanningResult result = edwa.plan(problem);
  ASSERT_TRUE(result.velocity_wanted.has_value());
  EXPECT_GT(result.velocity_wanted->y(), 0.02) << "HRVO passes on the left";
  EXPECT_GT(result.command.omega, 0.01);
  CriticsPlanner driver({}, no_evasion(), EdwaOptions{}, {});
  const Drive passing = drive(driver, problem, 250);
  EXPECT_GT(passing.smallest_gap, 0.0);
  EXPECT_TRUE(is_there(passing, {16, 0}));
}

TEST(CriticsPlanner, MirroredDriveIsTheMirroredDrive) {
  Random random(15);
  for (int i = 0; i < 20; ++i) {
    PlanningProblem problem = random_scene(random);
    problem.footprint = box();
    CriticsPlanner one({}, no_evasion()), other({}, no_evasion());
    const Drive a = drive(one, problem, 30);
    const Drive b = drive(other, mirrored(problem), 30);
    for (std::size_t k = 0; k < a.poses.size(); ++k) {
      ASSERT_NEAR(a.poses[k].x, b.poses[k].x, 1e-6) << i << " " << k;
      ASSERT_NEAR(a.poses[k].y, -b.poses[k].y, 1e-6) << i << " " << k;
    }
  }
}

}  // namespace
}  // namespace bw::dwa
