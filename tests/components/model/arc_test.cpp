#include "components/model/arc.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"
#include "components/model/wheel_step.hpp"

namespace bw {
namespace {

constexpr double kH = 1e-5;  // central differences: error of order h^2 = 1e-10

Eigen::Vector3d difference(const Pose2& a, const Pose2& b) {
  return {a.x - b.x, a.y - b.y, wrap_angle(a.theta - b.theta)};
}

Pose2 moved(Pose2 X, int axis, double h) {
  (axis == 0 ? X.x : axis == 1 ? X.y : X.theta) += h;
  return X;
}

TEST(ArcJacobian, MatchesNumericalDerivativesWithin1e6) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const Pose2 X{random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3.1, 3.1)};
    const double s = random.uniform(-2, 2);
    // Straight, nearly straight on both sides of the series' limit, and up to half a turn.
    const double t = i % 4 == 0 ? 0.0 : random.uniform(-1, 1) * (i % 4 == 1 ? 4e-3 : i % 4 == 2 ? 0.1 : 3.0);
    const ArcStep arc = arc_step(X, s, t);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d numerical =
          difference(advance_arc(moved(X, axis, kH), s, t), advance_arc(moved(X, axis, -kH), s, t)) /
          (2.0 * kH);
      ASSERT_LT((arc.by_pose.col(axis) - numerical).norm(), 1e-6) << i;
    }
    const Eigen::Vector3d by_s =
        difference(advance_arc(X, s + kH, t), advance_arc(X, s - kH, t)) / (2.0 * kH);
    const Eigen::Vector3d by_t =
        difference(advance_arc(X, s, t + kH), advance_arc(X, s, t - kH)) / (2.0 * kH);
    ASSERT_LT((arc.by_step.col(0) - by_s).norm(), 1e-6) << i;
    ASSERT_LT((arc.by_step.col(1) - by_t).norm(), 1e-6) << i;
  }
}

// model/README.md 2.2: for a straight step G of wheels = [[c/2 - s sin/(2b), ...]] exactly, since midpoint
// and arc agree.
TEST(ArcJacobian, StraightStepEqualsTheWheelFormOfTheBook) {
  const double b = 0.4, s = 0.3, theta = 0.7;
  const WheelStep step = step_from_wheels(Time{0}, Duration{1}, s, s, b, 1e-3);
  const Eigen::Matrix<double, 3, 2> G = arc_step({0, 0, theta}, s, 0.0).by_step;
  const double c = std::cos(theta), sn = std::sin(theta);
  Eigen::Matrix<double, 3, 2> spec;
  spec << c / 2 - s * sn / (2 * b), c / 2 + s * sn / (2 * b), sn / 2 + s * c / (2 * b),
      sn / 2 - s * c / (2 * b), 1 / b, -1 / b;
  const Eigen::Matrix3d expected = spec * (1e-3 * s) * spec.transpose();
  EXPECT_LT((G * step.covariance * G.transpose() - expected).norm(), 1e-15);
}

// A quarter of a circle of radius 2 to the left: from (0, 0, 0) to (2, 2, pi/2), and back.
TEST(Arc, QuarterOfACircleThereAndBack) {
  const double quarter = std::acos(0.0);
  const Pose2 end = advance_arc({}, 2.0 * quarter, quarter);
  EXPECT_LT(difference(end, {2.0, 2.0, quarter}).norm(), 1e-14);
  EXPECT_LT(difference(advance_arc(end, -2.0 * quarter, -quarter), {}).norm(), 1e-14);
  const ArcTravel travel = arc_between({}, end);
  EXPECT_NEAR(travel.distance, 2.0 * quarter, 1e-14);
  EXPECT_NEAR(travel.rotation, quarter, 1e-14);
}

}  // namespace
}  // namespace bw
