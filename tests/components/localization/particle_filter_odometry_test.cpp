#include <cmath>

#include <gtest/gtest.h>

#include "components/localization/ekf/ekf.hpp"
#include "components/localization/particle_filter/odometry_track.hpp"
#include "components/localization/particle_filter/particle_motion.hpp"
#include "components/localization/particle_filter/set_estimate.hpp"
#include "tests/components/localization/simulated_drive.hpp"

namespace bw::localization {
namespace {

ParticleMotionOptions plain() {
  ParticleMotionOptions options;
  options.walk = options.heading_walk = 0.0;
  options.gyro_bias_sigma = 0.0;
  return options;
}

WheelStep step_to(Time time, Duration over, double distance, double rotation) {
  WheelStep step;
  step.time = time;
  step.over = over;
  step.distance = distance;
  step.rotation = rotation;
  return step;
}

// The path and its covariance are those of the EKF without corrections (both exact arcs, first order).
TEST(OdometryTrack, WayAndCovarianceAreThoseOfTheEkf) {
  DriveOptions drive_options;
  drive_options.seconds = 5.0;
  drive_options.gyro_sigma = drive_options.compass_sigma = drive_options.gps_sigma = 0.0;
  const Drive drive = simulate(drive_options);
  OdometryTrack track(plain(), Duration::seconds(2.0));
  track.restart(kStart);
  Ekf ekf({});
  ekf.start_at({}, 1e-12 * Eigen::Matrix3d::Identity(), kStart);
  for (const Measurement& m : drive.measurements) {
    track.add(std::get<WheelStep>(m));
    ekf.add(m, stamp(m));
  }
  const UncertainMotion behind = track.behind();
  const Estimate e = ekf.estimate();
  EXPECT_NEAR(behind.X_BB.x, e.X_MB.x, 1e-9);
  EXPECT_NEAR(behind.X_BB.y, e.X_MB.y, 1e-9);
  EXPECT_NEAR(behind.X_BB.theta, e.X_MB.theta, 1e-9);
  EXPECT_LT((behind.covariance - e.covariance).cwiseAbs().maxCoeff(), 2e-8);  // the EKF's floors
}

// 1 m/s, 0.5 rad/s: between the steps the pose is on the arc, after the last one on its continuation.
TEST(OdometryTrack, KnowsThePoseAtAnyTimeOfTheWindow) {
  OdometryTrack track(plain(), Duration::seconds(2.0));
  track.restart(kStart);
  const Duration period = Duration::milliseconds(20);
  for (int i = 1; i <= 200; ++i) track.add(step_to(kStart + period * i, period, 0.02, 0.01));
  for (const double t : {2.1, 2.105, 3.0, 3.99, 4.0, 4.3}) {
    const Pose2 X = track.at(kStart + Duration::seconds(t));
    const Pose2 expected = advance_exact({}, {1.0, 0.5}, t);
    EXPECT_NEAR(X.x, expected.x, 2.6e-5) << t;  // a chord of 2 cm leaves the arc by 25 um
    EXPECT_NEAR(X.y, expected.y, 2.6e-5) << t;
    EXPECT_NEAR(wrap_angle(X.theta - expected.theta), 0.0, 1e-9) << t;
  }
  EXPECT_EQ(track.oldest(), kStart + Duration::seconds(2.0));
  // Held no longer than the extrapolation.
  EXPECT_EQ(track.at(kStart + Duration::seconds(4.5)), track.at(kStart + Duration::seconds(60.0)));
}

TEST(OdometryTrack, StepsOutOfOrderAndGaps) {
  OdometryTrack track(plain(), Duration::seconds(2.0));
  track.restart(kStart);
  const Duration period = Duration::milliseconds(100);
  EXPECT_TRUE(track.add(step_to(kStart + period, period, 0.1, 0.0)));
  EXPECT_FALSE(track.add(step_to(kStart + period, period, 0.1, 0.0)));
  EXPECT_FALSE(track.add(step_to(kStart, period, 0.1, 0.0)));
  // One lost: the next one counts twice.
  EXPECT_TRUE(track.add(step_to(kStart + period * 3, period, 0.1, 0.0)));
  EXPECT_NEAR(track.behind().X_BB.x, 0.3, 1e-12);
  // A long gap is unknown motion: (1 m/s x 1.9 s)^2 for the speed that stays unknown.
  EXPECT_TRUE(track.add(step_to(kStart + period * 23, period, 0.1, 0.0)));
  EXPECT_NEAR(track.behind().X_BB.x, 0.4, 1e-12);
  EXPECT_NEAR(track.behind().covariance(0, 0), 1.9 * 1.9, 1e-9);
}

// Straight 0.5 m: distance alpha3 d^2, both rotations alpha2 d^2, the first of them moves the end sideways by
// d.
TEST(OdometryTrack, AlphasAreAmcls) {
  ParticleMotionOptions options = plain();
  options.noise = MotionNoise::amcl;
  options.alpha1 = 0.1;
  options.alpha2 = 0.2;
  options.alpha3 = 0.3;
  options.alpha4 = 0.4;
  OdometryTrack track(options, Duration::seconds(2.0));
  track.restart(kStart);
  const Duration second = Duration::seconds(1.0);
  track.add(step_to(kStart + second, second, 0.5, 0.0));
  const Eigen::Matrix3d C = track.behind().covariance;
  EXPECT_NEAR(C(0, 0), 0.3 * 0.25, 1e-12);
  EXPECT_NEAR(C(1, 1), 0.2 * 0.25 * 0.25, 1e-12);
  EXPECT_NEAR(C(2, 2), 2.0 * 0.2 * 0.25, 1e-12);
  EXPECT_NEAR(C(1, 2), 0.2 * 0.25 * 0.5, 1e-12);
  // A rotation in place by 0.4: alpha1 rotation^2 of the heading, alpha4 rotation^2 of the distance.
  track.follow();
  track.add(step_to(kStart + second * 2, second, 0.0, 0.4));
  EXPECT_NEAR(track.behind().covariance(2, 2), 0.1 * 0.16, 1e-12);
  EXPECT_NEAR(track.behind().covariance(0, 0), 0.4 * 0.16, 1e-12);
  // Straight back is no rotation by half a circle.
  track.follow();
  track.add(step_to(kStart + second * 3, second, -0.5, 0.0));
  EXPECT_NEAR(track.behind().covariance(2, 2), 2.0 * 0.2 * 0.25, 1e-12);
}

// Wheels that rotate 10 % too far; the gyro gives 0.5 rad/s + bias 0.05, which 3 s of standing have shown.
TEST(OdometryTrack, TheGyroTurnsTheStep) {
  OdometryTrack track(plain(), Duration::seconds(2.0));
  track.restart(kStart);
  const auto drive = [&](int from, int to, double distance, double rotation, double rate) {
    for (int i = from; i < to; ++i) {
      const Time now = kStart + kStep * (i + 1);
      track.add(GyroReading{now, 1, rate, 1e-4});
      track.add(step_to(now, kStep, distance, rotation));
    }
  };
  drive(0, 300, 0.0, 0.0, 0.05);
  EXPECT_NEAR(track.gyro_bias(), 0.05, 1e-9);
  EXPECT_EQ(track.behind().X_BB.theta, 0.0);
  drive(300, 301, 0.008, 0.0055, 0.55);  // its trapezoid still holds half of the last rate
  track.follow();
  drive(301, 501, 0.008, 0.0055, 0.55);
  EXPECT_NEAR(track.behind().X_BB.theta, 1.0, 1e-9);
}

// 40,000 particles moved by a motion with correlated noise have its mean and covariance.
TEST(ParticleMotion, MovesByMeanAndCovariance) {
  ParticleSet set;
  set.resize(40'000);
  std::fill(set.weight.begin(), set.weight.end(), 1.0 / 40'000.0);
  std::fill(set.theta.begin(), set.theta.end(), 3.1);
  std::fill(set.x.begin(), set.x.end(), 5.0);
  UncertainMotion motion;
  motion.X_BB = {1.0, 0.2, 0.3};
  motion.covariance << 0.04, 0.01, 0.002, 0.01, 0.03, 0.003, 0.002, 0.003, 0.01;
  ParticleMotion mover(3);
  mover.move(set, motion);
  const SetEstimate e = estimate_of(set);
  const Pose2 expected = Pose2{5.0, 0.0, 3.1} * motion.X_BB;
  EXPECT_NEAR(e.X_MB.x, expected.x, 0.004);  // four standard errors, 4 x 0.2 / 200
  EXPECT_NEAR(e.X_MB.y, expected.y, 0.004);
  EXPECT_NEAR(wrap_angle(e.X_MB.theta - expected.theta), 0.0, 0.002);
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  R.topLeftCorner<2, 2>() << std::cos(3.1), -std::sin(3.1), std::sin(3.1), std::cos(3.1);
  const Eigen::Matrix3d C = R * motion.covariance * R.transpose();
  EXPECT_LT((e.covariance - C).cwiseAbs().maxCoeff(), 0.0012);  // 4 x 0.04 sqrt(2 / 40000)
  for (const double theta : set.theta) ASSERT_LE(std::abs(theta), std::numbers::pi + 1e-12);
}

// A covariance without extent in one direction, or with a rounding error there.
TEST(ParticleMotion, RootOfASingularCovariance) {
  Eigen::Matrix3d C;
  C << 4.0, 2.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 0.0;
  EXPECT_LT((square_root(C) * square_root(C).transpose() - C).cwiseAbs().maxCoeff(), 1e-12);
  C(1, 1) -= 1e-15;
  EXPECT_TRUE(square_root(C).allFinite());
  EXPECT_EQ(square_root(Eigen::Matrix3d::Zero()), Eigen::Matrix3d::Zero());
}

}  // namespace
}  // namespace bw::localization
