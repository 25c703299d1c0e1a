// From nodes to scans, against closed forms: the distance to a straight wall, the side an obstacle stands on,
// the time of a beam.
#include "components/laser/scan.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include "components/laser/revolution.hpp"

namespace bw::laser {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;
constexpr float kInfinity = std::numeric_limits<float>::infinity();

/// What a device sees that rotates once in `nodes` nodes of 1 ms, two and a half times, from its 0 degrees
/// on. `range_at` takes the angle as the device counts it, clockwise [rad].
std::vector<Revolution> revolve(const std::function<double(double)>& range_at, int nodes = 360,
                                bool flip = false) {
  RevolutionCollector collector(flip);
  std::vector<Revolution> over;
  for (int i = 0; i < nodes * 5 / 2; ++i) {
    const double angle = 360.0 / nodes * (i % nodes);
    const Node node{.starts_revolution = i % nodes == 0,
                    .quality = 20,
                    .angle_q6 = static_cast<std::uint16_t>(std::lround(angle * 64.0) % (360 * 64)),
                    .range_q2 = static_cast<std::uint16_t>(std::lround(range_at(angle * kDegree) * 4000.0))};
    const Time time = Time::seconds(100.0 + 0.001 * i);
    if (auto one = collector.add(node, time)) over.push_back(*one);
  }
  return over;
}

float at(const Scan& scan, double degrees) {
  const double beam = std::round((degrees * kDegree + kPi) / scan.angle_increment);
  return scan.ranges[static_cast<std::size_t>(beam) % scan.ranges.size()];
}

// The device begins at 0 degrees and is at the rear after half a turn, after one and a half, and at the end:
// two whole revolutions, 360 ms each, from 180 degrees on.
TEST(LaserRevolution, GoesFromRearToRear) {
  const auto over = revolve([](double) { return 2.0; });
  ASSERT_EQ(over.size(), 1U) << "two and a half turns end just before the third time at the rear";
  // 180 degrees itself is the last angle before the rear; 181 is the first behind it, at node 181.
  EXPECT_EQ(over[0].first, Time::seconds(100.181));
  EXPECT_EQ((over[0].next - over[0].first).nanoseconds, 360'000'000);
  ASSERT_EQ(over[0].samples.size(), 360U);
  EXPECT_NEAR(over[0].samples.front().angle, 179.0 * kDegree, 1e-9)
      << "181 clockwise is 179 counter-clockwise";
  EXPECT_NEAR(over[0].samples.back().angle, -kPi, 1e-9);
}

// A wall at x = 2 m: 2 / cos(angle) ahead, nothing behind. Ranges are whole quarters of a millimetre; angles
// whole degrees here, so that 1/64 degree rounds nothing: half a quarter of a millimetre is all that is lost.
TEST(LaserScan, SeesAWallAtTwoMetres) {
  const auto wall = [](double angle) {
    const double range = std::cos(angle) > 1e-9 ? 2.0 / std::cos(angle) : 1e9;
    return range < 12.0 ? range : 0.0;
  };
  const auto over = revolve(wall);
  ASSERT_EQ(over.size(), 1U);
  const Scan scan = to_scan(over[0], {.beams = 360});
  ASSERT_EQ(scan.ranges.size(), 360U);
  for (int i = 0; i < 360; ++i) {
    const double angle = -kPi + kDegree * i;
    const double truth = wall(angle);
    if (truth > 0.0)
      EXPECT_NEAR(scan.ranges[static_cast<std::size_t>(i)], truth, 0.00013) << i;
    else
      EXPECT_EQ(scan.ranges[static_cast<std::size_t>(i)], kInfinity) << i;
  }
}

// The same wall on beams that lie between the samples, more or fewer than those: 1/r of a wall is a cosine,
// of which a chord over 1 degree misses (1 degree)^2 / 8 = 38 millionths; at 60 degrees from head-on (4 m)
// 0.15 mm, and the rounding of 1/64 degree there is half of that times 4 m x tan 60 = 0.95 mm.
TEST(LaserScan, InterpolatesAWallAlongItsSurface) {
  const auto wall = [](double angle) { return std::cos(angle) > 0.3 ? 2.0 / std::cos(angle) : 0.0; };
  for (const int beams : {181, 400, 720}) {
    const auto over = revolve(wall, 367);
    ASSERT_FALSE(over.empty());
    const Scan scan = to_scan(over[0], {.beams = beams});
    for (std::size_t i = 0; i < scan.ranges.size(); ++i) {
      const double angle = -kPi + scan.angle_increment * static_cast<double>(i);
      if (std::cos(angle) <= 0.5) continue;
      EXPECT_NEAR(scan.ranges[i], 2.0 / std::cos(angle), 0.0013) << beams << " " << i;
    }
  }
}

// The device counts clockwise: what it sees at 90 degrees stands to the right, at -90 degrees. Head first it
// is to the left.
TEST(LaserScan, RightIsRight) {
  const auto right = [](double angle) {
    return std::abs(angle - 90.0 * kDegree) < 5.0 * kDegree ? 1.5 : 0.0;
  };
  const Scan scan = to_scan(revolve(right).at(0), {});
  EXPECT_FLOAT_EQ(at(scan, -90.0), 1.5F);
  EXPECT_EQ(at(scan, 90.0), kInfinity);
  const Scan flipped = to_scan(revolve(right, 360, true).at(0), {});
  EXPECT_FLOAT_EQ(at(flipped, 90.0), 1.5F);
  EXPECT_EQ(at(flipped, -90.0), kInfinity);
}

// Beam 0 is at the rear, the last of a clockwise revolution: 181 ms and a revolution of 360 ms after the
// beginning. Ahead is half a turn before that: the node at 0 degrees is number 360, at 100.360 s, and 181 +
// 180 = 361: the revolution is counted from the angle behind the rear.
TEST(LaserScan, KnowsWhenABeamWasTaken) {
  const Scan scan = to_scan(revolve([](double) { return 2.0; }).at(0), {.beams = 360});
  EXPECT_NEAR(scan.scan_time, 0.360, 1e-9);
  EXPECT_NEAR(scan.time_increment, -0.001, 1e-9);
  EXPECT_EQ(scan.time, Time::seconds(100.541));
  EXPECT_NEAR((scan.time - Time::seconds(100.360)).to_seconds() + 180.0 * scan.time_increment, 0.0, 0.0011);
  const Scan flipped = to_scan(revolve([](double) { return 2.0; }, 360, true).at(0), {.beams = 360});
  EXPECT_NEAR(flipped.time_increment, 0.001, 1e-9);
  EXPECT_EQ(flipped.time, Time::seconds(100.181));
}

TEST(LaserScan, SaysWhatItDidNotSee) {
  const auto ranges = [](double angle) { return angle < kPi / 2 ? 0.0 : angle < kPi ? 0.1 : 14.0; };
  const auto over = revolve(ranges);
  const Scan scan = to_scan(over.at(0), {});
  EXPECT_EQ(at(scan, -45.0), kInfinity) << "nothing measured";
  EXPECT_EQ(at(scan, -135.0), -kInfinity) << "nearer than range_min";
  EXPECT_EQ(at(scan, 90.0), kInfinity) << "farther than range_max";
  const Scan careful = to_scan(over.at(0), {.no_return = NoReturn::unknown});
  EXPECT_TRUE(std::isnan(at(careful, -45.0)));
}

// 30 degrees of nodes lost: the beams there know nothing, and their neighbours go on.
TEST(LaserScan, ABeamNobodyLookedAtIsUnknown) {
  auto over = revolve([](double) { return 2.0; });
  std::erase_if(over.at(0).samples, [](const Sample& sample) {
    return sample.angle > 30.5 * kDegree && sample.angle < 60.5 * kDegree;
  });
  const Scan scan = to_scan(over[0], {.beams = 360});
  EXPECT_TRUE(std::isnan(at(scan, 45.0)));
  EXPECT_FLOAT_EQ(at(scan, 30.0), 2.0F);
  EXPECT_FLOAT_EQ(at(scan, 61.0), 2.0F);
}

// Nothing between a leg and the wall behind it: a beam halfway says one or the other.
TEST(LaserScan, InventsNothingBetweenALegAndTheWall) {
  const auto leg = [](double angle) { return std::cos(angle) > std::cos(2.0 * kDegree) ? 2.0 : 4.0; };
  const Scan scan = to_scan(revolve(leg).at(0), {.beams = 720});
  for (const float range : scan.ranges) EXPECT_TRUE(range == 2.0F || range == 4.0F) << range;
}

// A chair's leg that one node of 1440 hits, on 360 beams of which none looks right at it.
TEST(LaserScan, LosesNothingThin) {
  const auto leg = [](double angle) { return std::abs(angle - 10.25 * kDegree) < 0.1 * kDegree ? 1.0 : 4.0; };
  const Scan scan = to_scan(revolve(leg, 1440).at(0), {.beams = 360});
  EXPECT_FLOAT_EQ(at(scan, -10.0), 1.0F);
}

// Angles that tremble by a quarter of a degree at the rear do not cut a revolution in two.
TEST(LaserRevolution, TremblingAnglesAreNoTurn) {
  RevolutionCollector collector(false);
  std::vector<Revolution> over;
  for (int i = 0; i < 360 * 4; ++i) {
    const int tremble = i % 2 == 0 ? 40 : -40;  // [1/64 degree]: back by 16 after each step of 64 less 80
    const Node node{.angle_q6 = static_cast<std::uint16_t>((i % 360 * 64 + tremble + 360 * 64) % (360 * 64)),
                    .range_q2 = 8000};
    if (auto one = collector.add(node, Time::seconds(0.001 * i))) over.push_back(*one);
  }
  ASSERT_EQ(over.size(), 3U);
  for (const Revolution& one : over) EXPECT_NEAR(static_cast<double>(one.samples.size()), 360.0, 2.0);
}

// A head that stands sends nodes for ever: no revolution, and memory is bounded.
TEST(LaserRevolution, AHeadThatStandsMakesNone) {
  RevolutionCollector collector(false);
  for (int i = 0; i < 100'000; ++i)
    EXPECT_FALSE(collector.add(Node{.angle_q6 = 5000, .range_q2 = 8000}, Time::seconds(0.001 * i)));
}

}  // namespace
}  // namespace bw::laser
