// The laser fails while the robot drives at top speed (rows 6 to 8 of tests/README.md): time from the last
// sound sweep until the wheels brake, and until the robot stands. Whole chain in virtual time: world, laser
// filter (this test), collision monitor, motor control, base.
//
// Brakes at the latest: 250 ms source_timeout + 20 ms cycle + 20 ms motor control + 10 ms physics, and 10 ms
// until 0.02 m/s are lost. Standstill: 1 m/s at 2 m/s^2 is 0.5 s after that.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/faults/guarded_drive.hpp"

namespace bw {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

using Ranges = std::vector<float>;
using Spoil = std::function<bool(Ranges&)>;  ///< false: no sweep at all

struct Stop {
  double braking = 0.0;   ///< [s] after the last sound sweep
  double standing = 0.0;  ///< [s] after the last sound sweep
  bool stopped = false;
  bool was_limited = false;  ///< before the fault
};

/// Drives at `speed` between two walls; from kFault + trial's phase on, sweeps are spoilt.
Stop drive_into_fault(const Spoil& spoil, double speed, int trial, int trials, double seconds = 2.5) {
  const double fault_at = 3.0 + 0.1 * trial / trials;
  double last_sound = 0.0;
  double top = 0.0;
  Stop stop;
  GuardedDrive drive;
  drive.world =
      "      walls: [{x1: -5.0, y1: -2.0, x2: 30.0, y2: -2.0}, {x1: -5.0, y1: 2.5, x2: 30.0, y2: 2.5}]\n";
  drive.wish = [speed](double) { return Twist2{speed, 0.0}; };
  drive.filter = [&](double t, sensor_msgs::msg::LaserScan& scan) {
    if (t < fault_at) {
      last_sound = t;
      return true;
    }
    return spoil(scan.ranges());
  };
  drive.see = [&](double t, const bandwagon_msgs::msg::GroundTruth& truth) {
    const double v = truth.twist().linear().x();
    if (t <= fault_at) top = std::max(top, v);
    if (t > 2.5 && t <= fault_at && v < 0.98 * speed) stop.was_limited = true;
    if (t <= fault_at) return;
    if (stop.braking == 0.0 && v < top - 0.02) stop.braking = t - last_sound;
    if (!stop.stopped && v < 0.001) {
      stop.standing = t - last_sound;
      stop.stopped = true;
    }
  };
  drive.seed = static_cast<std::uint64_t>(trial + 1);
  drive.run(fault_at + seconds);
  return stop;
}

TEST(LaserFaults, ASilentLaserBrakesTheRobotWithin300Ms) {
  const int trials = fault_trials();
  double latest_braking = 0.0;
  double latest_standing = 0.0;
  for (int i = 0; i < trials; ++i) {
    const Stop stop = drive_into_fault([](Ranges&) { return false; }, 1.0, i, trials);
    ASSERT_TRUE(stop.stopped) << i;
    EXPECT_FALSE(stop.was_limited) << i;
    latest_braking = std::max(latest_braking, stop.braking);
    latest_standing = std::max(latest_standing, stop.standing);
  }
  RecordProperty("latest_braking", std::to_string(latest_braking));
  std::printf("silent laser, %d trials: braking after %.0f ms, standing after %.0f ms at the latest\n",
              trials, 1e3 * latest_braking, 1e3 * latest_standing);
  EXPECT_LE(latest_braking, 0.31);
  EXPECT_LE(latest_standing, 0.81);
}

struct Kind {
  const char* name;
  std::function<void(Ranges&, Random&)> spoil;
};

class LostSweeps : public ::testing::TestWithParam<Kind> {};

TEST_P(LostSweeps, AreASilentLaser) {
  const int trials = std::max(6, fault_trials() / 10);
  double latest = 0.0;
  for (int i = 0; i < trials; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Stop stop = drive_into_fault(
        [&](Ranges& ranges) {
          GetParam().spoil(ranges, random);
          return true;
        },
        1.0, i, trials);
    ASSERT_TRUE(stop.stopped) << i;
    latest = std::max(latest, stop.braking);
  }
  std::printf("%s, %d trials: braking after %.0f ms at the latest\n", GetParam().name, trials, 1e3 * latest);
  EXPECT_LE(latest, 0.31);
}

void fill(Ranges& ranges, float value) { std::fill(ranges.begin(), ranges.end(), value); }

INSTANTIATE_TEST_SUITE_P(
    Kinds, LostSweeps,
    ::testing::Values(Kind{"nan", [](Ranges& r, Random&) { fill(r, kNan); }},
                      Kind{"infinite", [](Ranges& r, Random&) { fill(r, kInfinity); }},
                      Kind{"too_near", [](Ranges& r, Random&) { fill(r, -kInfinity); }},
                      Kind{"zero", [](Ranges& r, Random&) { fill(r, 0.0F); }},
                      Kind{"negative", [](Ranges& r, Random&) { fill(r, -3.0F); }},
                      Kind{"too_short", [](Ranges& r, Random&) { r.resize(r.size() / 2); }},
                      Kind{"too_long", [](Ranges& r, Random&) { r.resize(2 * r.size(), 4.0F); }},
                      Kind{"empty", [](Ranges& r, Random&) { r.clear(); }},
                      Kind{"mostly_nan",
                           [](Ranges& r, Random& random) {
                             for (float& range : r) {
                               if (random.uniform() < 0.8) range = kNan;
                             }
                           }}),
    [](const auto& kind) { return std::string(kind.param.name); });

TEST(LaserFaults, AFrozenLaserIsFoundWithinASecondOfMoving) {
  const int trials = std::max(6, fault_trials() / 10);
  for (const double speed : {0.1, 1.0}) {
    double latest = 0.0;
    for (int i = 0; i < trials; ++i) {
      Ranges kept;
      const Stop stop = drive_into_fault(
          [&](Ranges& ranges) {
            if (kept.empty()) kept = ranges;
            ranges = kept;
            return true;
          },
          speed, i, trials);
      ASSERT_TRUE(stop.stopped) << i;
      latest = std::max(latest, stop.braking);
    }
    std::printf("frozen laser at %.1f m/s, %d trials: braking after %.0f ms at the latest\n", speed, trials,
                1e3 * latest);
    EXPECT_LE(latest, 1.0);
  }
}

TEST(LaserFaults, TenPercentOfUnusableBeamsDoNotStopTheRobot) {
  for (int i = 0; i < 6; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const float value =
        std::vector<float>{kNan, kInfinity, -kInfinity, 0.0F, -1.0F, 30.0F}.at(static_cast<std::size_t>(i));
    const Stop stop = drive_into_fault(
        [&](Ranges& ranges) {
          for (float& range : ranges) {
            if (random.uniform() < 0.1) range = value;
          }
          return true;
        },
        1.0, i, 6);
    EXPECT_EQ(stop.braking, 0.0) << value;
    EXPECT_FALSE(stop.stopped) << value;
  }
}

// No walls: every beam of every sweep is +inf, and rightly so.
TEST(LaserFaults, AnOpenPlaceIsNoFault) {
  double slowest = 1.0;
  int hits = 0;
  GuardedDrive drive;
  drive.wish = [](double) { return Twist2{1.0, 0.0}; };
  drive.filter = [&](double, sensor_msgs::msg::LaserScan& scan) {
    hits += static_cast<int>(std::count_if(scan.ranges().begin(), scan.ranges().end(),
                                           [](float range) { return std::isfinite(range); }));
    return true;
  };
  drive.see = [&](double t, const bandwagon_msgs::msg::GroundTruth& truth) {
    if (t > 2.5) slowest = std::min(slowest, truth.twist().linear().x());
  };
  drive.run(8.0);
  EXPECT_EQ(hits, 0);
  EXPECT_GT(slowest, 0.98);
}

// Out of a hall into the open: the last walls are left behind, and with them all returns. The laser sees 135
// degrees to either side; the ends of the walls at x = 3 leave its field 2.5 m further on.
TEST(LaserFaults, LeavingAHallForAnOpenPlaceIsNoFault) {
  double slowest = 1.0;
  int hits_at_end = -1;
  GuardedDrive drive;
  drive.world =
      "      walls: [{x1: -5.0, y1: -2.0, x2: 3.0, y2: -2.0}, {x1: -5.0, y1: 2.5, x2: 3.0, y2: 2.5}]\n";
  drive.wish = [](double) { return Twist2{1.0, 0.0}; };
  drive.filter = [&](double, sensor_msgs::msg::LaserScan& scan) {
    hits_at_end = static_cast<int>(std::count_if(scan.ranges().begin(), scan.ranges().end(),
                                                 [](float range) { return std::isfinite(range); }));
    return true;
  };
  drive.see = [&](double t, const bandwagon_msgs::msg::GroundTruth& truth) {
    if (t > 2.5) slowest = std::min(slowest, truth.twist().linear().x());
  };
  drive.run(12.0);
  EXPECT_EQ(hits_at_end, 0);
  EXPECT_GT(slowest, 0.98);
}

}  // namespace
}  // namespace bw
