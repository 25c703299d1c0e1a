// The first pose, the health states, and clocks that jump.
#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "components/localization/ekf/ekf.hpp"
#include "tests/components/localization/simulated_drive.hpp"

namespace bw::localization {
namespace {

DriveOptions somewhere(std::uint64_t seed) {
  Random random(seed);
  DriveOptions options;
  options.seed = seed;
  options.start = {random.uniform(-100, 100), random.uniform(-100, 100), random.uniform(-3.1, 3.1)};
  return options;
}

bool has(const Health& health, HealthCause cause) {
  for (const HealthReason& reason : health.reasons)
    if (reason.cause == cause) return true;
  return false;
}

// Runs until the first pose; the index of the wheel step then, or -1.
int first_pose(Ekf& ekf, const std::vector<Measurement>& measurements) {
  int step = 0;
  for (const Measurement& m : measurements) {
    if (std::holds_alternative<WheelStep>(m)) ++step;
    ekf.add(m, stamp(m));
    if (ekf.initialised()) return step;
  }
  return -1;
}

// Five compass readings at 10 Hz and three fixes at 5 Hz: known at the third fix, 0.6 s.
TEST(EkfStart, CompassAndFixesGiveAPoseWithinItsCovariance) {
  int within = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const Drive drive = simulate(somewhere(seed));
    Ekf ekf({});
    const int step = first_pose(ekf, drive.measurements);
    ASSERT_EQ(step, 60);
    const Estimate e = ekf.estimate();
    const Pose2& truth = drive.truth[60];
    const Eigen::Vector3d error(e.X_MB.x - truth.x, e.X_MB.y - truth.y,
                                wrap_angle(e.X_MB.theta - truth.theta));
    if (error.dot(e.covariance.llt().solve(error)) <= 7.815) ++within;
  }
  EXPECT_GE(within, 95);  // of 95 % at least: the covariance is doubled on purpose
}

// One bad first sample of each (a compass 2 rad off, a fix 42 m off) spoils nothing.
TEST(EkfStart, OneBadSampleSpoilsNothing) {
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    Drive drive = simulate(somewhere(seed));
    bool heading_spoilt = false, fix_spoilt = false;
    for (Measurement& m : drive.measurements) {
      if (auto* h = std::get_if<HeadingReading>(&m); h != nullptr && !heading_spoilt) {
        h->heading = wrap_angle(h->heading + 2.0);
        heading_spoilt = true;
      }
      if (auto* f = std::get_if<PositionFix>(&m); f != nullptr && !fix_spoilt) {
        f->position.x() += 42.0;
        fix_spoilt = true;
      }
    }
    Ekf ekf({});
    const int step = first_pose(ekf, drive.measurements);
    ASSERT_GT(step, 60);
    const Pose2& truth = drive.truth[static_cast<std::size_t>(step)];
    EXPECT_LT((ekf.estimate().X_MB.position() - truth.position()).norm(), 2.0) << seed;
    EXPECT_LT(std::abs(wrap_angle(ekf.estimate().X_MB.theta - truth.theta)), 0.25) << seed;
  }
}

TEST(EkfStart, WithoutCompassTheWayGivesTheHeading) {
  int within = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    DriveOptions options = somewhere(seed);
    options.compass_sigma = 0.0;
    options.gps_sigma = 0.1;
    Drive drive = simulate(options);
    int fixes = 0;
    for (Measurement& m : drive.measurements)
      if (auto* f = std::get_if<PositionFix>(&m); f != nullptr && ++fixes == 5) f->position.y() -= 42.0;
    Ekf ekf({});
    const int step = first_pose(ekf, drive.measurements);
    ASSERT_GE(step, 250);  // 2 m at 0.8 m/s
    const Estimate e = ekf.estimate();
    const Pose2& truth = drive.truth[static_cast<std::size_t>(step)];
    EXPECT_LT((e.X_MB.position() - truth.position()).norm(), 0.5) << seed;
    const double error = wrap_angle(e.X_MB.theta - truth.theta);
    if (error * error <= 3.841 * e.covariance(2, 2)) ++within;
  }
  EXPECT_GE(within, 95);
}

// A skidding base of large footprint rotates uncertainly (0.05 rad per root metre); with fixes of 0.9 m only
// every 8 m the path still gives a heading, within its covariance.
TEST(EkfStart, FewFixesGiveTheHeadingOfABaseThatTurnsUncertainly) {
  int within = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    DriveOptions options = somewhere(seed);
    options.seconds = 120.0;
    options.turn_rate_amplitude = 0.05;
    options.separation = 0.57;
    options.wheel_variance = 4e-4;
    options.compass_sigma = 0.0;
    options.gps_sigma = 0.9;
    options.gps_every = 1000;
    const Drive drive = simulate(options);
    Ekf ekf({});
    const int step = first_pose(ekf, drive.measurements);
    ASSERT_GE(step, 4000) << seed;  // four fixes
    ASSERT_LE(step, 7000) << seed;
    const Estimate e = ekf.estimate();
    const double error = wrap_angle(e.X_MB.theta - drive.truth[static_cast<std::size_t>(step)].theta);
    if (error * error <= 3.841 * e.covariance(2, 2)) ++within;
  }
  EXPECT_GE(within, 93);  // 95 of 100 expected, less one standard deviation of that count
}

TEST(EkfStart, AStandingRobotWithoutCompassWaits) {
  DriveOptions options;
  options.speed = options.turn_rate_amplitude = options.compass_sigma = 0.0;
  Ekf ekf({});
  EXPECT_EQ(first_pose(ekf, simulate(options).measurements), -1);
  const Health health = ekf.health(step_time(6000));
  EXPECT_EQ(health.state, HealthState::init);
  ASSERT_EQ(health.reasons.size(), 1U);
  EXPECT_EQ(health.reasons[0].cause, HealthCause::no_heading);
}

// A compass whose zero is off by up to 0.6 rad: with the offset estimated, the first heading is as unsure as
// the offset, and after a minute of driving the fixes have told both apart. 10 seeds, all within four
// standard deviations at the start and within 0.1 rad at the end (0.5 m over some 48 m of travel).
TEST(EkfStart, ACompassOfUnknownOffsetIsNotBelievedAtFirst) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    DriveOptions drive_options = somewhere(seed);
    drive_options.compass_offset = -0.6 + 0.12 * static_cast<double>(seed);
    const Drive drive = simulate(drive_options);
    EkfOptions options;
    options.bias.heading_offset = true;
    options.bias.heading_offset_walk = 0.0;
    Ekf ekf(options);
    const int step = first_pose(ekf, drive.measurements);
    ASSERT_GT(step, 0);
    const Estimate first = ekf.estimate();
    const double first_error =
        wrap_angle(first.X_MB.theta - drive.truth[static_cast<std::size_t>(step)].theta);
    EXPECT_GE(std::sqrt(first.covariance(2, 2)), options.bias.heading_offset_sigma);
    EXPECT_LE(std::abs(first_error), 4.0 * std::sqrt(first.covariance(2, 2))) << seed;
    for (const Measurement& m : drive.measurements) {
      if (stamp(m) > first.time) ekf.add(m, stamp(m));
    }
    const Estimate last = ekf.estimate();
    EXPECT_LT(std::abs(wrap_angle(last.X_MB.theta - drive.truth.back().theta)), 0.1) << seed;
    EXPECT_NEAR(last.heading_offset, drive_options.compass_offset, 0.1) << seed;
  }
}

TEST(EkfStart, RefusesAPoseThatIsNone) {
  Ekf ekf({});
  EXPECT_FALSE(ekf.start_at({std::nan(""), 0, 0}, Eigen::Matrix3d::Identity(), kStart));
  EXPECT_FALSE(ekf.start_at({}, Eigen::Matrix3d::Zero(), kStart));
  EXPECT_FALSE(ekf.start_at({}, -Eigen::Matrix3d::Identity(), kStart));
  EXPECT_FALSE(ekf.initialised());
}

// Receiver lost at 20 s: DEGRADED within 1 s (+ one fix period); LOST once two standard deviations pass 2 m;
// OK again soon after it is back.
TEST(EkfHealth, OutageDegradesThenLosesThenHeals) {
  DriveOptions options;
  options.seconds = 300.0;
  options.turn_rate_amplitude = 0.05;
  options.compass_sigma = options.gyro_sigma = 0.0;
  const Drive drive = simulate(options);
  Ekf ekf({});
  double degraded = 0.0, lost = 0.0;
  for (const Measurement& m : drive.measurements) {
    const double t = (stamp(m) - kStart).to_seconds();
    if (std::holds_alternative<PositionFix>(m) && t > 20.0 && t < 290.0) continue;
    ekf.add(m, stamp(m));
    if (!std::holds_alternative<WheelStep>(m) || !ekf.initialised() || t > 290.0) continue;
    const Health health = ekf.health(stamp(m));
    if (t > 15.0 && t < 20.0) {
      ASSERT_EQ(health.state, HealthState::ok) << t;
    }
    if (degraded == 0.0 && t > 20.0 && health.state == HealthState::degraded) {
      degraded = t;
      EXPECT_TRUE(has(health, HealthCause::source_silent));
    }
    if (lost == 0.0 && health.state == HealthState::lost) {
      lost = t;
      EXPECT_GT(health.two_sigma, 2.0);
      EXPECT_LT(health.two_sigma, 2.1);
    }
  }
  EXPECT_GT(degraded, 20.9);
  EXPECT_LT(degraded, 21.25);
  EXPECT_GT(lost, 22.0);
  EXPECT_EQ(ekf.health(step_time(30000)).state, HealthState::ok);
}

// Carried 10 m away while fixes go on: LOST within 3 s + one fix period.
TEST(EkfHealth, AKidnappedRobotIsLostWithinThreeSeconds) {
  DriveOptions options;
  options.seconds = 30.0;
  const Drive drive = simulate(options);
  Ekf ekf({});
  double lost = 0.0;
  for (Measurement m : drive.measurements) {
    auto* fix = std::get_if<PositionFix>(&m);
    const double t = (stamp(m) - kStart).to_seconds();
    if (fix != nullptr && t > 20.0) fix->position.x() += 10.0;
    ekf.add(m, stamp(m));
    if (ekf.initialised() && lost == 0.0 && t > 15.0 && ekf.health(stamp(m)).state == HealthState::lost)
      lost = t;
  }
  EXPECT_GT(lost, 20.2);
  EXPECT_LE(lost, 23.21);
}

TEST(EkfHealth, SilentWheelsDegradeAndTheVarianceGrowsWithTheSquareOfTime) {
  DriveOptions options;
  options.seconds = 10.0;
  options.gyro_sigma = 0.0;
  const Drive drive = simulate(options);
  Ekf ekf({});
  for (const Measurement& m : drive.measurements) ekf.add(m, stamp(m));
  const double before = ekf.state().P(0, 0);
  HeadingReading heading;
  heading.source = kCompass;
  heading.variance = 10.0;  // says next to nothing
  heading.time = step_time(1300);
  heading.heading = drive.truth.back().theta;
  EXPECT_TRUE(used(ekf.add(heading, heading.time).verdict));
  // 3 s without wheels at a standard deviation of 1 m/s: 9 m^2.
  EXPECT_NEAR(ekf.state().P(0, 0), before + 9.0, 0.1);
  EXPECT_TRUE(has(ekf.health(heading.time), HealthCause::wheels_silent));
}

class EkfClock : public ::testing::Test {
 protected:
  void run(Ekf& ekf, double from, double to, Duration stamp_shift, Duration now_shift) {
    for (Measurement m : drive_.measurements) {
      const double t = (stamp(m) - kStart).to_seconds();
      if (t <= from || t > to) continue;
      const Time now = stamp(m) + now_shift;
      std::visit([&](auto& value) { value.time = value.time + stamp_shift; }, m);
      ekf.add(m, now);
    }
  }
  double error(const Ekf& ekf, double t) const {
    const auto i = static_cast<std::size_t>(std::lround(t * 100.0));
    return (ekf.estimate().X_MB.position() - drive_.truth[i].position()).norm();
  }
  Drive drive_ = simulate({});
};

const Duration kHour = Duration::seconds(3600.0);

// A record that begins again: both clocks go back an hour.
TEST_F(EkfClock, BothClocksBackHoldThePose) {
  Ekf ekf({});
  run(ekf, 0.0, 20.0, kHour, kHour);
  const double before = error(ekf, 20.0);
  run(ekf, 20.0, 20.01, {}, {});
  EXPECT_EQ(ekf.clock_jumps(), 1U);
  EXPECT_TRUE(ekf.initialised());
  EXPECT_TRUE(has(ekf.health(step_time(2001)), HealthCause::clock_jump));
  EXPECT_LT(error(ekf, 20.01), before + 0.05);
  run(ekf, 20.01, 60.0, {}, {});
  EXPECT_LT(error(ekf, 60.0), 0.5);
  EXPECT_EQ(ekf.health(step_time(6000)).state, HealthState::ok);
}

TEST_F(EkfClock, ResetFindsANewFirstPose) {
  EkfOptions options;
  options.on_clock_jump = OnClockJump::reset;
  Ekf ekf(options);
  run(ekf, 0.0, 20.0, kHour, kHour);
  run(ekf, 20.0, 20.05, {}, {});
  EXPECT_FALSE(ekf.initialised());
  EXPECT_EQ(ekf.health(step_time(2005)).state, HealthState::init);
  run(ekf, 20.05, 60.0, {}, {});
  EXPECT_TRUE(ekf.initialised());
  EXPECT_LT(error(ekf, 60.0), 0.5);
}

// The sensors' clock is set an hour on or back: refused for a second (ForeignClock::kProof), then taken as a
// jump.
TEST_F(EkfClock, SensorClocksThatAreSetAreFollowed) {
  for (const double hours : {1.0, -0.2}) {
    const Duration shift = Duration::seconds(3600.0 * hours);
    Ekf ekf({});
    run(ekf, 0.0, 20.0, {}, {});
    run(ekf, 20.0, 20.99, shift, {});
    EXPECT_EQ(ekf.clock_jumps(), 0U);
    EXPECT_GE(ekf.count(Verdict::future) + ekf.count(Verdict::too_old),
              99U * 2U);  // wheels and gyro, and a compass
    run(ekf, 20.99, 60.0, shift, {});
    EXPECT_EQ(ekf.clock_jumps(), 1U);
    EXPECT_LT(error(ekf, 60.0), 0.5);
    EXPECT_EQ(ekf.health(step_time(6000)).state, HealthState::ok);
  }
}

// A queue that drains, and steps sent twice, are no clock: 30 steps of 5 s ago, one after the other, are
// refused and forgotten.
TEST_F(EkfClock, OldStepsThatAreSentAgainAreNoClock) {
  Ekf ekf({});
  run(ekf, 0.0, 20.0, {}, {});
  const Pose2 before = ekf.estimate().X_MB;
  for (int i = 0; i < 30; ++i) {
    const Time stamp = step_time(1500 + i);
    EXPECT_EQ(ekf.add(step_from_twist(stamp, Duration::milliseconds(10), {0.5, 0.0}, Eigen::Matrix2d::Zero()),
                      step_time(2000))
                  .verdict,
              Verdict::too_old);
  }
  EXPECT_EQ(ekf.clock_jumps(), 0U);
  EXPECT_EQ(ekf.estimate().X_MB, before);
}

TEST_F(EkfClock, OneWildStampIsAFaultOfOneMessage) {
  Ekf clean({}), disturbed({});
  Random random(3);
  for (const Measurement& m : drive_.measurements) {
    clean.add(m, stamp(m));
    disturbed.add(m, stamp(m));
    if (random.uniform() > 0.05) continue;
    Measurement wild = m;
    std::visit([&](auto& value) { value.time = value.time + Duration::seconds(random.uniform(10, 1e6)); },
               wild);
    EXPECT_EQ(disturbed.add(wild, stamp(m)).verdict, Verdict::future);
  }
  EXPECT_EQ(disturbed.clock_jumps(), 0U);
  EXPECT_EQ(clean.estimate().X_MB, disturbed.estimate().X_MB);
}

}  // namespace
}  // namespace bw::localization
