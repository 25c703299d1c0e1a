#include "components/lab/bench/band_evaluator.hpp"

#include <gtest/gtest.h>

namespace bw {
namespace {

SceneFile rules() {
  SceneFile file;
  file.limits.v_max = 0.4;
  file.limits.acc_max = 0.5;
  file.min_dist = 0.5;
  file.inflation_dist = 0.6;
  file.dynamic_inflation_dist = 0.6;
  file.weights = {2, 1, 1, 1, 1000, 1, 1, 50, 0.1, 50, 0.1, 0.05};
  return file;
}

// Three poses on the x axis, 0.2 m and 1 s apart: |d| s(100 d) = 0.2 * 20 / 21 m/s.
const std::vector<EvaluatedPose> kLine{{{0, 0, 0}, 1.0}, {{0.2, 0, 0}, 1.0}, {{0.4, 0, 0}, 0.0}};
constexpr double kSpeed = 0.2 * 20.0 / 21.0;

TEST(BandEvaluator, StraightLineByHand) {
  const BandQuality q = evaluate_band(kLine, {0.0, 0.0}, rules(), {});
  EXPECT_DOUBLE_EQ(q.time, 2.0);
  EXPECT_DOUBLE_EQ(q.cost.time, 2.0);
  EXPECT_EQ(q.cost.nonholonomic, 0.0);
  EXPECT_EQ(q.cost.velocity, 0.0);
  EXPECT_EQ(q.cost.acceleration, 0.0);
  EXPECT_NEAR(segment_twist(kLine[0], kLine[1]).v, kSpeed, 1e-12);
}

TEST(BandEvaluator, StartAccelerationByHand) {
  // From 1 m/s: a = (v - 1) / 1 = -0.8095, 0.3095 beyond 0.5, cost (0.3095 + 0.05)^2.
  const BandQuality q = evaluate_band(kLine, {1.0, 0.0}, rules(), {});
  const double excess = 1.0 - kSpeed - 0.5;
  EXPECT_NEAR(q.excess_a, excess, 1e-12);
  EXPECT_NEAR(q.cost.acceleration, (excess + 0.05) * (excess + 0.05), 1e-12);
}

TEST(BandEvaluator, ObstaclesCountAtInnerPosesAndTheirOwnTime) {
  // The mover is at (0.2, 0.4) when the robot is at the inner pose (t = 1). The cost is
  // 50 (0.55 - 0.4)^2 + 0.1 (0.6 - 0.4)^2.
  const std::vector<SceneObstacle> mover{{{0.2, 1.4}, 0.0, {0.0, -1.0}}};
  const BandQuality q = evaluate_band(kLine, {}, rules(), mover);
  EXPECT_NEAR(q.cost.obstacle, 50 * 0.15 * 0.15 + 0.1 * 0.2 * 0.2, 1e-12);
  EXPECT_NEAR(q.clearance_poses, 0.4, 1e-12);
  // At t = 1.4 it crosses the line y = 0 at x = 0.2, 0.08 m behind the robot.
  EXPECT_NEAR(q.clearance_segments, 0.08, 1e-9);
}

TEST(BandEvaluator, NonholonomicByHand) {
  // A sideways step of 0.1 m at heading 0: h = (1 + 1) * 0.1.
  const std::vector<EvaluatedPose> sideways{{{0, 0, 0}, 1.0}, {{0, 0.1, 0}, 0.0}};
  const BandQuality q = evaluate_band(sideways, {}, rules(), {});
  EXPECT_NEAR(q.max_nonholonomic, 0.2, 1e-12);
  EXPECT_NEAR(q.cost.nonholonomic, 1000 * 0.04, 1e-9);
}

}  // namespace
}  // namespace bw
