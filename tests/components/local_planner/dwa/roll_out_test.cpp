// Roll-outs of a real footprint against closed forms.
#include "components/local_planner/dwa/roll_out.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/model/footprint_distance.hpp"
#include "components/model/random.hpp"
#include "tests/components/local_planner/planner_drive.hpp"

namespace bw::dwa {
namespace {

constexpr double kLook = 0.05;  // [m] between two looks

// 0.5 x 0.4 m.
Footprint long_box() {
  return {std::hypot(0.25, 0.2), {{0.25, 0.2}, {-0.25, 0.2}, {-0.25, -0.2}, {0.25, -0.2}}};
}

RollOutRules rules() { return {.horizon = 2.0, .distance = 100.0, .margin = 0.0, .reach = 0.5}; }

TEST(RollOut, ReachesItsVelocityWithinTheLimits) {
  // From rest to 1 m/s at 1 m/s^2: 0.5 m in the first second, 1 m in the next.
  const PlanningProblem problem = problem_to({9, 0, 0});
  RollOuts roll_outs(problem, rules());
  const RollOut out = roll_outs.along({1.0, 0.0});
  EXPECT_NEAR(out.end.x, 1.5, 1e-3);
  EXPECT_NEAR(out.travel, 1.5, 1e-3);
  EXPECT_NEAR(out.time, 2.0, 1e-9);
  // Rotating from rest to 1 rad/s at 1.5 rad/s^2: 1/3 rad in 2/3 s, then 4/3 rad.
  EXPECT_NEAR(roll_outs.along({0.0, 1.0}).rotation, 5.0 / 3.0, 2e-3);
  EXPECT_EQ(roll_outs.along({0.0, 0.0}).travel, 0.0);
}

TEST(RollOut, EndsWhereTheWayEnds) {
  PlanningProblem problem = problem_to({9, 0, 0});
  problem.twist = {1.0, 0.0};
  RollOutRules short_distance = rules();
  short_distance.distance = 0.7;
  const RollOut out = RollOuts(problem, short_distance).along({1.0, 0.0});
  EXPECT_NEAR(out.travel, 0.7, 1e-9);
  EXPECT_NEAR(out.end.x, 0.7, 1e-9);
  EXPECT_FALSE(out.meets);
}

TEST(RollOut, TheFootprintItselfMeetsAWall) {
  // Across at 1.5 m: the front is 0.25 m ahead, the corners rotate to no effect; a disc would be 0.32 m
  // ahead.
  PlanningProblem problem = problem_to({9, 0, 0});
  problem.footprint = long_box();
  problem.twist = {1.0, 0.0};
  problem.obstacles.segments = {{{1.5, -5.0}, {1.5, 5.0}}};
  const RollOut out = RollOuts(problem, rules()).along({1.0, 0.0});
  EXPECT_TRUE(out.meets);
  EXPECT_LE(out.travel, 1.25);
  EXPECT_GE(out.travel, 1.25 - kLook);
  // A gap of 0.5 m for a body of 0.4 m: 5 cm to either side, where its disc does not fit.
  problem.obstacles.segments = {{{1.0, 0.25}, {9.0, 0.25}}, {{1.0, -0.25}, {9.0, -0.25}}};
  const RollOut through = RollOuts(problem, rules()).along({1.0, 0.0});
  EXPECT_FALSE(through.meets);
  EXPECT_NEAR(through.gap, 0.05, 1e-9);
}

TEST(RollOut, ATurnOnTheSpotMeetsWhatTheCornersReach) {
  // A point 0.3 m to the left of a body that reaches 0.2 m to that side: rotated by phi it is seen at 0.3 m
  // (sin phi, cos phi), and the side meets it when 0.3 cos phi = 0.2.
  PlanningProblem problem = problem_to({9, 0, 0});
  problem.footprint = long_box();
  problem.obstacles.points = {{0.0, 0.3}};
  problem.twist = {0.0, 1.0};
  const RollOut out = RollOuts(problem, rules()).along({0.0, 1.0});
  ASSERT_TRUE(out.meets);
  const double rotation = std::acos(0.2 / 0.3);
  EXPECT_NEAR(out.rotation, rotation, kLook / 0.3);
  EXPECT_LE(out.rotation, rotation + 1e-9);
}

TEST(RollOut, InsideTheMarginNothingMayComeCloser) {
  PlanningProblem problem = problem_to({9, 0, 0});
  problem.twist = {0.5, 0.0};
  problem.obstacles.points = {{0.34, 0.0}};  // 4 cm before the disc of 0.3 m
  RollOutRules wide = rules();
  wide.margin = 0.1;
  RollOuts roll_outs(problem, wide);
  EXPECT_NEAR(roll_outs.gap_now(), 0.04, 1e-12);
  EXPECT_NEAR(roll_outs.margin(), 0.039, 1e-12);
  EXPECT_TRUE(roll_outs.along({0.5, 0.0}).meets);
  problem.obstacles.points = {{-0.34, 0.0}};
  EXPECT_FALSE(RollOuts(problem, wide).along({0.5, 0.0}).meets) << "behind it: it leads away";
  problem.obstacles.points = {{-0.25, 0.0}};  // 5 cm inside of it
  EXPECT_FALSE(RollOuts(problem, wide).along({0.5, 0.0}).meets) << "it may leave";
  problem.obstacles.points = {{0.25, 0.0}};
  EXPECT_TRUE(RollOuts(problem, wide).along({0.5, 0.0}).meets);
}

TEST(RollOut, MoversStandOrWalk) {
  // Somebody crosses 2 m ahead from 2 m to the right at 1 m/s: met after 2 s, or never if they stood.
  PlanningProblem problem = problem_to({9, 0, 0});
  problem.twist = {1.0, 0.0};
  Mover mover;
  mover.position = {2.0, -2.0};
  mover.velocity = {0.0, 1.0};
  problem.movers = {mover};
  RollOutRules rules_here = rules();
  EXPECT_FALSE(RollOuts(problem, rules_here).along({1.0, 0.0}).meets);
  rules_here.predict_movers = true;
  EXPECT_TRUE(RollOuts(problem, rules_here).along({1.0, 0.0}).meets);
  mover.confidence = 0.4;  // possible, not confirmed: nobody
  problem.movers = {mover};
  EXPECT_FALSE(RollOuts(problem, rules_here).along({1.0, 0.0}).meets);
}

TEST(RollOut, GapAgreesWithFineSampling) {
  Random random(8);
  for (int scene = 0; scene < 200; ++scene) {
    PlanningProblem problem = problem_to({9, 0, 0});
    problem.footprint = long_box();
    problem.twist = {random.uniform(0.0, 1.0), random.uniform(-1, 1)};
    for (int i = 0; i < 12; ++i) {
      const double x = random.uniform(-2, 3);
      problem.obstacles.points.push_back({x, random.uniform(-2, 2)});
    }
    if (gap_to_statics(problem.pose, problem.footprint, problem.obstacles) < 0.01) continue;
    const double v = random.uniform(0.0, 1.0);
    const Twist2 held{v, random.uniform(-1, 1)};
    RollOuts roll_outs(problem, rules());
    const RollOut out = roll_outs.along(held);
    double least = 0.5;
    for (const TrajectoryPoint& point : roll_outs.trajectory(held, out.time))
      least = std::min(least, gap_to_statics(point.pose, problem.footprint, problem.obstacles));
    EXPECT_GE(least, -0.5 * kLook) << scene << ": not more than half a look deep between looks";
    EXPECT_NEAR(out.gap, std::max(least, 0.0), kLook) << scene;
  }
}

}  // namespace
}  // namespace bw::dwa
