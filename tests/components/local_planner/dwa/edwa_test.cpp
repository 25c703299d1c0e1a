// What EDWA changes: it turns to where HRVO points and drives as fast as HRVO says.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/local_planner/dwa/dwa_planner.hpp"
#include "components/model/random.hpp"
#include "tests/components/local_planner/planner_drive.hpp"
#include "tests/components/local_planner/planner_scenes.hpp"

namespace bw::dwa {
namespace {

DrivingOptions without_evasion() {
  DrivingOptions options;
  options.evasion_horizon = 0.0;
  return options;
}

DwaPlanner edwa_with(EdwaHeading heading, bool hrvo_speed = true) {
  DwaOptions options;
  options.carrot_distance = 0.0;
  EdwaOptions edwa;
  edwa.heading = heading;
  edwa.hrvo_speed = hrvo_speed;
  return DwaPlanner(options, without_evasion(), towards_hrvo(edwa, {}, without_evasion()));
}

// Somebody comes towards the robot, a little to its right: HRVO points to the left.
PlanningProblem head_on(double y) {
  PlanningProblem problem = problem_to({16, 0, 0});
  problem.twist = {0.8, 0.0};
  Mover m;
  m.position = {6.0, y};
  m.velocity = {-0.8, 0.0};
  problem.movers = {m};
  return problem;
}

TEST(Edwa, TurnsToTheSideOfHrvo) {
  DwaPlanner planner = edwa_with(EdwaHeading::hrvo);
  const PlanningResult result = planner.plan(head_on(-0.2));
  ASSERT_TRUE(result.velocity_wanted.has_value());
  EXPECT_GT(result.velocity_wanted->y(), 0.02) << "HRVO passes on the left";
  EXPECT_GT(result.command.omega, 0.01);
  EXPECT_EQ(result.velocity_cones.size(), 1U);
}

TEST(Edwa, PrintedFormTurnsToTheOtherSide) {
  // (3.4) compares HRVO's direction with the bearing of the goal, which moves left when the robot goes right.
  DwaPlanner planner = edwa_with(EdwaHeading::hrvo_printed);
  EXPECT_LT(planner.plan(head_on(-0.2)).command.omega, -0.01);
}

TEST(Edwa, WithTheGoalAsHeadingAndTheHighestSpeedIsDwa) {
  Random random(4);
  DwaOptions options;
  options.carrot_distance = 0.0;
  for (int i = 0; i < 50; ++i) {
    PlanningProblem problem = head_on(random.uniform(-1, 1));
    problem.pose.theta = random.uniform(-1, 1);
    DwaPlanner dwa(options, without_evasion());
    DwaPlanner edwa = edwa_with(EdwaHeading::goal, false);
    EXPECT_EQ(dwa.plan(problem).command, edwa.plan(problem).command);
  }
}

TEST(Edwa, WithoutNeighboursHeadsForTheGoal) {
  // HRVO is then the straight path: a goal at 0.2 rad asks for w = 0.2 after 1 s; 0.15 is what is reached.
  PlanningProblem problem = problem_to({10.0 * std::cos(0.2), 10.0 * std::sin(0.2), 0});
  problem.twist = {0.8, 0.0};
  DwaPlanner planner = edwa_with(EdwaHeading::hrvo);
  EXPECT_NEAR(planner.plan(problem).command.omega, 0.15, 1e-9);
  problem.twist.omega = 0.1;
  EXPECT_NEAR(planner.plan(problem).command.omega, 0.2, 0.0075) << "half a sample's spacing";
}

TEST(Edwa, DrivesAtTheSpeedOfHrvo) {
  // A person ahead walks away at 0.4 m/s, walls left and right: HRVO cannot pass and follows him.
  PlanningProblem problem = problem_to({16, 0, 0});
  problem.twist = {0.7, 0.0};
  problem.obstacles.segments = {{{-2.0, 0.9}, {20.0, 0.9}}, {{-2.0, -0.9}, {20.0, -0.9}}};
  Mover m;
  m.position = {2.5, 0.0};
  m.velocity = {0.4, 0.0};
  problem.movers = {m};
  DwaPlanner by_speed = edwa_with(EdwaHeading::hrvo, true);
  DwaPlanner fast = edwa_with(EdwaHeading::hrvo, false);
  const PlanningResult result = by_speed.plan(problem);
  ASSERT_LT(result.velocity_wanted->norm(), 0.6);
  EXPECT_NEAR(result.command.v, 0.6, 1e-9) << "0.1 m/s slower is all that 0.1 s allows";
  EXPECT_GT(fast.plan(problem).command.v, 0.7);
}

TEST(Edwa, ArrivesAtRest) {
  for (const Pose2& goal : {Pose2{4, 0, 0}, Pose2{3, 2, 1.5}, Pose2{-2, 0.5, 3.0}, Pose2{0, 0.5, 0}}) {
    DwaPlanner planner = edwa_with(EdwaHeading::hrvo);
    EXPECT_TRUE(is_at_rest_at(goal, drive(planner, problem_to(goal), 300))) << goal.x << " " << goal.y;
  }
}

TEST(Edwa, MirroredSceneGivesMirroredCommands) {
  Random random(9);
  for (int i = 0; i < 60; ++i) {
    PlanningProblem problem = head_on(random.uniform(0.1, 1.0));
    problem.pose.theta = random.uniform(-0.4, 0.4);
    problem.movers.push_back(problem.movers[0]);
    problem.movers[1].position = {random.uniform(2, 6), random.uniform(-5, -2)};
    problem.movers[1].velocity = {0.0, random.uniform(0.3, 1.0)};
    DwaPlanner planner = edwa_with(EdwaHeading::hrvo);
    const PlanningResult a = planner.plan(problem);
    const PlanningResult b = planner.plan(mirrored(problem));
    EXPECT_NEAR(a.command.v, b.command.v, 1e-6) << i;
    EXPECT_NEAR(a.command.omega, -b.command.omega, 1e-6) << i;
  }
}

TEST(Edwa, GoesAroundAStaticObstacle) {
  // HRVO has a cone for what stands, too.
  PlanningProblem problem = problem_to({8, 0, 0});
  problem.obstacles.discs = {{{3.0, 0.15}, 0.3}};
  DwaPlanner planner = edwa_with(EdwaHeading::hrvo);
  const Drive result = drive(planner, problem, 250);
  EXPECT_GT(result.smallest_gap, 0.05);
  EXPECT_LE((result.poses.back().position() - Vector2(8, 0)).norm(), 0.2);
}

TEST(Edwa, PassesSomebodyWhoDoesNotGiveWay) {
  DwaPlanner planner = edwa_with(EdwaHeading::hrvo);
  for (const double y : {-0.4, 0.1, 0.6}) {
    const Drive result = drive(planner, head_on(y), 250);
    EXPECT_GT(result.smallest_gap, 0.0) << y;
    EXPECT_LE((result.poses.back().position() - Vector2(16, 0)).norm(), 0.2) << y;
    planner.reset();
  }
}

}  // namespace
}  // namespace bw::dwa
