// Wheels whose counts are coarse beside a gyro: a count that has not come yet is no proof that the robot does
// not rotate.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/localization/ekf/ekf.hpp"
#include "tests/components/localization/simulated_drive.hpp"

namespace bw::localization {
namespace {

constexpr double kTick = 2.0 * std::numbers::pi * 0.0762 / 144.0;  // Eddie's (model/README.md 2.3): 3.3 mm
constexpr double kSeparation = 0.39;

/// Rotates slowly to and fro in place, as a robot does that stands before people: a wheel counts 7 times a
/// second at most.
DriveOptions slow_rotations(std::uint64_t seed) {
  DriveOptions options;
  options.seed = seed;
  options.seconds = 60.0;
  options.speed = 0.0;
  options.turn_rate_amplitude = 0.12;
  options.separation = kSeparation;
  options.wheel_variance = 1e-6;
  options.tick = kTick;
  options.gyro_sigma = 0.005;
  options.gyro_bias = 0.005;
  options.compass_sigma = 0.0;
  options.gps_sigma = 0.0;
  return options;
}

struct Course {
  double worst = 0.0;             ///< error of the heading [rad]
  double worst_normalised = 0.0;  ///< by the filter's own standard deviation
  double bias = 0.0;              ///< of the gyro, as estimated at the end [rad/s]
};

Course follow(const DriveOptions& options) {
  const Drive drive = simulate(options);
  Ekf ekf({});
  EXPECT_TRUE(ekf.start_at(options.start, 1e-6 * Eigen::Matrix3d::Identity(), kStart));
  Course course;
  std::size_t step = 0;
  for (const Measurement& m : drive.measurements) {
    ekf.add(m, stamp(m));
    if (!std::holds_alternative<WheelStep>(m)) continue;
    const Estimate e = ekf.estimate();
    const double error = std::abs(wrap_angle(e.X_MB.theta - drive.truth[++step].theta));
    course.worst = std::max(course.worst, error);
    course.worst_normalised = std::max(course.worst_normalised, error / std::sqrt(e.covariance(2, 2)));
    course.bias = e.gyro_bias;
  }
  return course;
}

// These wheels do not slip: what both have counted is off by one count each at most, 2 tick / b = 17 mrad,
// whatever the gyro says.
TEST(EkfRounding, SlowTurnsAreNotLostBetweenCounts) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const Course course = follow(slow_rotations(seed));
    EXPECT_LT(course.worst, 2.0 * kTick / kSeparation) << "seed " << seed;
    EXPECT_LT(course.worst_normalised, 4.0) << "seed " << seed;
    EXPECT_NEAR(course.bias, 0.005, 0.002) << "seed " << seed;
  }
}

// The same without a gyro: roundings of steps that adjoin take one another back, and do not add up to a
// heading that is ever less known. 6000 of them as white noise would be 2 * 3.5 mrad * sqrt(6000) = 0.4 rad.
TEST(EkfRounding, DoesNotAddUp) {
  DriveOptions options = slow_rotations(1);
  options.gyro_sigma = 0.0;
  const Drive drive = simulate(options);
  Ekf ekf({});
  ASSERT_TRUE(ekf.start_at(options.start, 1e-6 * Eigen::Matrix3d::Identity(), kStart));
  for (const Measurement& m : drive.measurements) ekf.add(m, stamp(m));
  const Estimate e = ekf.estimate();
  EXPECT_LT(std::sqrt(e.covariance(2, 2)), 2.0 * kTick / kSeparation);
  EXPECT_NEAR(wrap_angle(e.X_MB.theta - drive.truth.back().theta), 0.0, 2.0 * kTick / kSeparation);
}

// Wheels that rotate 50 % further than the robot for a second, at 0.5 rad/s on the spot: 0.25 rad too far,
// fifteen times what counts can hide.
TEST(EkfRounding, SlipIsStillSeen) {
  DriveOptions options = slow_rotations(1);
  options.turn_rate_amplitude = 0.5;
  options.slip_from = 4.5;  // at the largest turn rate
  options.slip_left = options.slip_right = 1.5;
  EXPECT_LT(follow(options).worst, 0.06);
}

}  // namespace
}  // namespace bw::localization
