#include <cmath>

#include <gtest/gtest.h>

#include "components/localization/ekf/arc.hpp"
#include "components/localization/ekf/observation.hpp"
#include "components/localization/wheel_step.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/random.hpp"

namespace bw::localization {
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
    const ArcStep arc = advance_arc(X, s, t);
    const Pose2 exact = advance_exact(X, {s, t}, 1.0);
    ASSERT_LT(difference(arc.pose, exact).norm(), 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d numerical = difference(advance_arc(moved(X, axis, kH), s, t).pose,
                                                   advance_arc(moved(X, axis, -kH), s, t).pose) /
                                        (2.0 * kH);
      ASSERT_LT((arc.by_pose.col(axis) - numerical).norm(), 1e-6) << i;
    }
    const Eigen::Vector3d by_s =
        difference(advance_arc(X, s + kH, t).pose, advance_arc(X, s - kH, t).pose) / (2.0 * kH);
    const Eigen::Vector3d by_t =
        difference(advance_arc(X, s, t + kH).pose, advance_arc(X, s, t - kH).pose) / (2.0 * kH);
    ASSERT_LT((arc.by_step.col(0) - by_s).norm(), 1e-6) << i;
    ASSERT_LT((arc.by_step.col(1) - by_t).norm(), 1e-6) << i;
  }
}

// Book 2.2: for a straight step G of wheels = [[c/2 - s sin/(2b), ...]] exactly, since midpoint and arc
// agree.
TEST(ArcJacobian, StraightStepEqualsTheWheelFormOfTheBook) {
  const double b = 0.4, s = 0.3, theta = 0.7;
  const WheelStep step = step_from_wheels(Time{0}, Duration{1}, s, s, b, 1e-3);
  const Eigen::Matrix<double, 3, 2> G = advance_arc({0, 0, theta}, s, 0.0).by_step;
  const double c = std::cos(theta), sn = std::sin(theta);
  Eigen::Matrix<double, 3, 2> wheel_form;
  wheel_form << c / 2 - s * sn / (2 * b), c / 2 + s * sn / (2 * b), sn / 2 + s * c / (2 * b),
      sn / 2 - s * c / (2 * b), 1 / b, -1 / b;
  const Eigen::Matrix3d expected = wheel_form * (1e-3 * s) * wheel_form.transpose();
  EXPECT_LT((G * step.covariance * G.transpose() - expected).norm(), 1e-15);
}

EkfState random_state(Random& random) {
  EkfState state;
  state.x << random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3.1, 3.1),
      random.uniform(-0.1, 0.1), random.uniform(-0.5, 0.5);
  state.twist = {random.uniform(-1, 1), random.uniform(-1, 1)};
  state.time = state.last_wheel = Time::seconds(100.0);
  return state;
}

// H = - d residual / d state for every kind, between two wheel steps (extrapolated by up to 0.4 s).
TEST(ObservationJacobian, MatchesNumericalDerivativesWithin1e6) {
  Random random(2);
  const MotionOptions motion;
  for (int i = 0; i < 500; ++i) {
    const EkfState state = random_state(random);
    const Time time = state.time + Duration::seconds(random.uniform(0.0, 0.4));
    PositionFix fix;
    fix.position = {random.uniform(-50, 50), random.uniform(-50, 50)};
    fix.antenna = {random.uniform(-1, 1), random.uniform(-1, 1)};
    PoseReading pose;
    pose.X_MB = {1.0, 2.0, random.uniform(-3, 3)};
    HeadingReading heading;
    heading.heading = random.uniform(-3, 3);
    CourseReading course;
    course.course = random.uniform(-3, 3);
    RangeReading range;
    range.anchor = {random.uniform(-50, 50), random.uniform(-50, 50)};
    range.antenna = {random.uniform(-1, 1), random.uniform(-1, 1)};
    const auto residuals = [&](const StateVector& x) {
      EkfState there = state;
      there.x = x;
      const Extrapolated at = extrapolate(there, time, motion);
      Eigen::Matrix<double, 8, 1> r;
      r << observe(fix, at).residual, observe(pose, at).residual, observe(heading, at, x(4)).residual,
          observe(course, at, state.twist.v < 0).residual, observe(range, at).residual;
      return r;
    };
    const Extrapolated at = extrapolate(state, time, motion);
    Eigen::Matrix<double, 8, kStates> H;
    H << observe(fix, at).H, observe(pose, at).H, observe(heading, at, state.x(4)).H,
        observe(course, at, state.twist.v < 0).H, observe(range, at).H;
    for (int k = 0; k < kStates; ++k) {
      StateVector h = StateVector::Zero();
      h(k) = kH;
      Eigen::Matrix<double, 8, 1> change = residuals(state.x - h) - residuals(state.x + h);
      for (const int angle : {4, 5, 6}) change(angle) = wrap_angle(change(angle));
      ASSERT_LT((H.col(k) - change / (2.0 * kH)).norm(), 1e-6) << i << " state " << k;
    }
  }
}

}  // namespace
}  // namespace bw::localization
