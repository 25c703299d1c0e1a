#include <cmath>

#include <gtest/gtest.h>

#include "components/localization/ekf/observation.hpp"
#include "components/model/random.hpp"

namespace bw::localization {
namespace {

constexpr double kH = 1e-5;  // central differences: error of order h^2 = 1e-10

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
