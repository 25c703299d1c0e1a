// The filter with a laser in a floor of several rooms. Scenarios on the conditions of
// localization/evidence.md 9.2 are in map_localization_test.cpp.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/localization/particle_filter/particle_filter.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/wheel_step.hpp"
#include "tests/components/localization/particle_filter_rooms.hpp"

namespace bw::localization {
namespace {

const ParticleFilterOptions kLaserDefaults;

constexpr Duration kPeriod = Duration::milliseconds(100);

// A robot that drives a round through the rooms at 0.6 m/s; wheels with 1e-3 m of variance per metre.
class Rover {
 public:
  explicit Rover(std::uint64_t seed) : random_(seed), sweeper_(rooms(), seed) {}

  Time now = Time::seconds(1000.0);
  Pose2 X;
  bool stands = false;

  void put_at(std::size_t stop) {
    next_ = (stop + 1) % kStops.size();
    const Vector2 ahead = kStops[next_] - kStops[stop];
    X = {kStops[stop].x(), kStops[stop].y(), std::atan2(ahead.y(), ahead.x())};
  }

  Outcome drive_on(ParticleFilter& filter) {
    now = now + kPeriod;
    if ((kStops[next_] - X.position()).norm() < 0.3) next_ = (next_ + 1) % kStops.size();
    const Vector2 ahead = kStops[next_] - X.position();
    const double rotation = wrap_angle(std::atan2(ahead.y(), ahead.x()) - X.theta);
    const Twist2 twist =
        stands ? Twist2{}
               : Twist2{std::abs(rotation) > 0.5 ? 0.0 : 0.6, std::clamp(2.0 * rotation, -1.0, 1.0)};
    const WheelSpeeds wheels = to_wheel_speeds(twist, 0.4);
    const auto measured = [&](double speed) {
      const double distance = 0.1 * speed;
      return distance + std::sqrt(1e-3 * std::abs(distance)) * random_.normal();
    };
    X = advance_exact(X, twist, 0.1);
    const double left = measured(wheels.left);
    filter.add(step_from_wheels(now, kPeriod, left, measured(wheels.right), 0.4, 1e-3), now);
    return filter.add(sweeper_.sweep(now, X), now);
  }

  double error(const ParticleFilter& filter) const {
    return (filter.estimate_at(now).X_MB.position() - X.position()).norm();
  }

  static const inline std::vector<Vector2> kStops{{2, 5},  {6, 6},    {8, 10.5},   {8, 14},  {4, 14},
                                                  {8, 14}, {8, 10.5}, {10.5, 5},   {14, 5},  {14, 8},
                                                  {18, 8}, {14, 5},   {10.5, 1.2}, {6, 1.2}, {2, 1.2}};

 private:
  Random random_;
  Sweeper sweeper_;
  std::size_t next_ = 0;
};

constexpr double kSigmas[3] = {0.1, 0.1, 0.07};
Eigen::Matrix3d start_covariance() {
  return Eigen::Vector3d(kSigmas[0] * kSigmas[0], kSigmas[1] * kSigmas[1], kSigmas[2] * kSigmas[2])
      .asDiagonal();
}

// localization/evidence.md 9.3: RMSE <= 0.08 m, largest error <= 0.21 m, at most 850 particles on average.
TEST(ParticleFilterLaser, Tracks) {
  for (const MotionNoise noise : {MotionNoise::declared, MotionNoise::amcl}) {
    ParticleFilterOptions options;
    options.motion.noise = noise;
    Rover rover(1);
    ParticleFilter filter(options, 1);
    filter.set_map(rooms());
    rover.put_at(0);
    filter.start_at(rover.X, start_covariance(), rover.now);
    double squares = 0.0, largest = 0.0, particles = 0.0;
    int not_ok = 0;
    constexpr int kSweeps = 1500;
    for (int i = 0; i < kSweeps; ++i) {
      rover.drive_on(filter);
      if (i < 10) continue;
      const double error = rover.error(filter);
      squares += error * error / (kSweeps - 10);
      largest = std::max(largest, error);
      particles += static_cast<double>(filter.particles()->size()) / (kSweeps - 10);
      const HealthState state = filter.health(rover.now).state;
      ASSERT_NE(state, HealthState::lost) << i;
      if (state != HealthState::ok) ++not_ok;
    }
    RecordProperty("rmse_" + std::string(text_of(noise)), std::to_string(std::sqrt(squares)));
    RecordProperty("largest_" + std::string(text_of(noise)), std::to_string(largest));
    EXPECT_LE(std::sqrt(squares), 0.08) << text_of(noise);
    EXPECT_LE(largest, 0.21) << text_of(noise);
    EXPECT_LE(particles, 850.0) << text_of(noise);
    // These wheels leave the heading 2 degrees off after a quick rotation: far walls miss until the next
    // sweep counts.
    EXPECT_LE(not_ok, kSweeps / 100) << text_of(noise);
  }
}

TEST(ParticleFilterLaser, ASweepCountsAfterWayOrTurn) {
  ParticleFilter filter(kLaserDefaults, 2);
  filter.set_map(rooms());
  Rover rover(2);
  rover.put_at(0);
  filter.start_at(rover.X, start_covariance(), rover.now);
  EXPECT_EQ(rover.drive_on(filter).verdict, Verdict::accepted);  // the first one always
  int used = 0;
  for (int i = 0; i < 50; ++i) used += rover.drive_on(filter).verdict == Verdict::accepted ? 1 : 0;
  EXPECT_NEAR(used, 10, 1);  // 3 m straight on, a sweep every fifth step of 6 cm (0.3 m >= 0.25 m)
  rover.stands = true;
  for (int i = 0; i < 10; ++i) rover.drive_on(filter);
  EXPECT_EQ(rover.drive_on(filter).verdict, Verdict::unusable);
  filter.use_next_sweep();
  EXPECT_EQ(rover.drive_on(filter).verdict, Verdict::accepted);
}

// Started anywhere: LOST until one place is left, then OK; within 25 used sweeps (localization/evidence.md
// 9.3), all of 10.
TEST(ParticleFilterLaser, FindsItselfOnTheWholeMap) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ParticleFilter filter(kLaserDefaults, seed);
    filter.set_map(rooms());
    Rover rover(seed);
    rover.put_at(static_cast<std::size_t>(seed));
    ASSERT_TRUE(filter.start_anywhere(rover.now));
    EXPECT_EQ(filter.health(rover.now).state, HealthState::lost);
    int used = 0;
    bool ok = false;
    while (used < 25 && !ok) {
      used += rover.drive_on(filter).verdict == Verdict::accepted ? 1 : 0;
      ok = filter.health(rover.now).state == HealthState::ok;
      if (ok) {
        EXPECT_LT(rover.error(filter), 0.4) << seed;
      }
    }
    EXPECT_TRUE(ok) << seed;
  }
}

// Carried from stop to stop while the wheels say nothing: back within 30 used sweeps, all of 10.
TEST(ParticleFilterLaser, FindsItselfAfterBeingCarriedAway) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    ParticleFilter filter(kLaserDefaults, seed);
    filter.set_map(rooms());
    Rover rover(seed);
    rover.put_at(0);
    filter.start_at(rover.X, start_covariance(), rover.now);
    for (int i = 0; i < 50; ++i) rover.drive_on(filter);
    rover.put_at(static_cast<std::size_t>(seed) + 2);
    int used = 0;
    int good = 0;
    while (used < 30 && good < 5) {
      if (rover.drive_on(filter).verdict != Verdict::accepted) continue;
      ++used;
      good = rover.error(filter) < 0.4 ? good + 1 : 0;
    }
    EXPECT_EQ(good, 5) << seed;
    for (int i = 0; i < 20; ++i) rover.drive_on(filter);
    EXPECT_EQ(filter.health(rover.now).state, HealthState::ok) << seed;
  }
}

// The same without recovery, standing still: LOST within 3 s all the same, and it stays so.
TEST(ParticleFilterLaser, AMismatchIsLostWithinThreeSeconds) {
  ParticleFilterOptions options;
  options.recovery.enabled = false;
  ParticleFilter filter(options, 3);
  filter.set_map(rooms());
  Rover rover(3);
  rover.put_at(0);
  filter.start_at(rover.X, start_covariance(), rover.now);
  for (int i = 0; i < 50; ++i) rover.drive_on(filter);
  EXPECT_EQ(filter.health(rover.now).state, HealthState::ok);
  rover.put_at(10);
  rover.stands = true;
  for (int i = 0; i < 30; ++i) rover.drive_on(filter);
  EXPECT_EQ(filter.health(rover.now).state, HealthState::lost);
}

TEST(ParticleFilterLaser, GarbageIsRefusedByName) {
  ParticleFilter filter(kLaserDefaults, 4);
  Rover rover(4);
  rover.put_at(0);
  Sweeper sweeper(rooms());
  LaserReading reading = sweeper.sweep(rover.now, rover.X);
  EXPECT_EQ(filter.add(reading, rover.now).verdict, Verdict::unusable);  // no pose yet
  filter.start_at(rover.X, start_covariance(), rover.now);
  EXPECT_EQ(filter.add(reading, rover.now).verdict, Verdict::unusable);  // no map
  EXPECT_EQ(filter.health(rover.now).state, HealthState::degraded);
  filter.set_map(rooms());
  const auto verdict = [&](auto change) {
    LaserReading bad = sweeper.sweep(rover.now, rover.X);
    change(bad);
    return filter.add(bad, rover.now).verdict;
  };
  EXPECT_EQ(verdict([](LaserReading& r) { r.angle_min = NAN; }), Verdict::implausible);
  EXPECT_EQ(verdict([](LaserReading& r) { r.X_FL.x = 1e9; }), Verdict::implausible);
  EXPECT_EQ(verdict([](LaserReading& r) { r.range_max = -1.0; }), Verdict::implausible);
  EXPECT_EQ(verdict([](LaserReading& r) { r.source = 8; }), Verdict::bad_source);
  EXPECT_EQ(verdict([](LaserReading& r) { r.time = r.time + Duration::seconds(1.0); }), Verdict::future);
  rover.now = rover.now + kPeriod;
  EXPECT_EQ(verdict([](LaserReading& r) { r.ranges = {}; }), Verdict::implausible);
  rover.now = rover.now + kPeriod;
  EXPECT_EQ(verdict([](LaserReading&) {}), Verdict::accepted);
  EXPECT_EQ(verdict([](LaserReading&) {}), Verdict::duplicate);
  std::vector<float> wild(360);
  for (int k = 0; k < 200; ++k) {
    const float values[] = {NAN, INFINITY, -INFINITY, 0.0F, -1.0F, 1e30F, 3.0F};
    for (std::size_t i = 0; i < wild.size(); ++i) wild[i] = values[(i * 7 + static_cast<std::size_t>(k)) % 7];
    rover.now = rover.now + kPeriod;
    filter.use_next_sweep();
    verdict([&](LaserReading& r) { r.ranges = wild; });
    ASSERT_TRUE(is_finite(filter.estimate_at(rover.now).X_MB));
  }
}

}  // namespace
}  // namespace bw::localization
