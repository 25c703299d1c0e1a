#include "components/local_planner/footprint_check.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace bw {
namespace {

const Footprint kDisc{0.3, {}};
const Footprint kBox{0.57, {{0.4, 0.4}, {-0.4, 0.4}, {-0.4, -0.4}, {0.4, -0.4}}};

TEST(GapAt, DiscFootprint) {
  StaticObstacles statics;
  statics.points = {{2.0, 0.0}};
  EXPECT_NEAR(gap_at({0, 0, 0}, 0.0, kDisc, statics, {}), 1.7, 1e-12);
  statics.discs = {{{0.0, 1.0}, 0.2}};
  EXPECT_NEAR(gap_at({0, 0, 0}, 0.0, kDisc, statics, {}), 0.5, 1e-12);
  statics.segments = {{{-1.0, -0.4}, {1.0, -0.4}}};
  EXPECT_NEAR(gap_at({0, 0, 0}, 0.0, kDisc, statics, {}), 0.1, 1e-12);
}

TEST(GapAt, PolygonDecidesWithinItsEnclosingDisc) {
  StaticObstacles statics;
  statics.points = {{0.5, 0.0}};  // inside the disc of 0.57 m, 0.1 m from the box
  EXPECT_NEAR(gap_at({0, 0, 0}, 0.0, kBox, statics, {}), 0.1, 1e-12);
  EXPECT_LT(gap_at({0, 0, 0.785398}, 0.0, kBox, statics, {}), 0.0)
      << "a corner of the turned box reaches 0.566 m";
  statics.points = {{0.1, 0.1}};
  EXPECT_LT(gap_at({0, 0, 0}, 0.0, kBox, statics, {}), 0.0) << "inside";
  statics.points.clear();
  statics.segments = {{{-1.0, 0.0}, {1.0, 0.0}}};
  EXPECT_LT(gap_at({0, 0, 0}, 0.0, kBox, statics, {}), 0.0) << "through the box, ends outside";
}

TEST(GapAlong, SeesAMoverWhereItIsAtThatTime) {
  // The robot crosses x = 1 at t = 1 s, a mover crosses the same point at t = 1 s (contact) or at t = 3 s
  // (clear).
  const std::vector<TrajectoryPoint> drive{{0.0, {0, 0, 0}, {1, 0}}, {2.0, {2, 0, 0}, {1, 0}}};
  PlanningProblem problem;
  Mover mover;
  mover.position = {1.0, -1.0};
  mover.velocity = {0.0, 1.0};
  problem.movers = {mover};
  const MotionGap met = gap_along(drive, 5.0, 0.05, 0.0, problem);
  EXPECT_LT(met.gap, -0.5);
  // Centres are sqrt(2) |t - 1| apart and touch at 0.6: t = 1 - 0.424.
  EXPECT_NEAR(met.contact_time, 0.576, 0.06);
  problem.movers[0].position = {1.0, -3.0};
  EXPECT_GT(gap_along(drive, 5.0, 0.05, 0.0, problem).gap, 0.3);
  EXPECT_TRUE(std::isinf(gap_along(drive, 5.0, 0.05, 0.0, problem).contact_time));
}

TEST(GapAlong, LooksBetweenPosesAndOnlyWithinItsHorizon) {
  const std::vector<TrajectoryPoint> drive{{0.0, {0, 0, 0}, {1, 0}}, {4.0, {4, 0, 0}, {1, 0}}};
  PlanningProblem problem;
  problem.obstacles.points = {{2.0, 0.0}};
  EXPECT_NEAR(gap_along(drive, 5.0, 0.05, 0.0, problem).gap, -0.3, 0.03);
  EXPECT_NEAR(gap_along(drive, 1.0, 0.05, 0.0, problem).gap, 0.7, 0.06);
}

}  // namespace
}  // namespace bw
