#include "components/model/laser_sweep.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(LaserSweep, ABeamIsAHitFreeOrUnknown) {
  LaserSweep sweep{.range_min = 0.1, .range_max = 10.0};
  using enum BeamKind;
  EXPECT_EQ(kind_of(kInfinity, sweep), free);
  for (const float range : {0.2F, 10.0F}) EXPECT_EQ(kind_of(range, sweep), hit) << range;
  for (const float range : {kNan, -kInfinity, -1.0F, -0.0F, 0.0F, 0.09F, 10.1F, 1e30F})
    EXPECT_EQ(kind_of(range, sweep), unknown) << range;
  sweep.range_min = 0.0;  // zero is what many drivers say for no reading, whatever range_min is
  EXPECT_EQ(kind_of(0.0F, sweep), unknown);
  EXPECT_EQ(kind_of(1e-3F, sweep), hit);
}

TEST(LaserSweep, FaultsOfTheWholeAreNamed) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  const std::vector<float> blind(400, kNan);  // what beams say is another matter
  const auto fault = [&](auto change) {
    LaserSweep sweep{.angle_min = -1.0,
                     .angle_increment = 0.01,
                     .range_max = 10.0,
                     .ranges = std::span(blind).first(201),
                     .angle_max = 1.0};
    change(sweep);
    return fault_of(sweep);
  };
  const auto beams = [&](std::size_t count) { return std::span(blind).first(count); };
  using enum SweepFault;
  using S = LaserSweep;
  EXPECT_EQ(fault([](S&) {}), none);
  EXPECT_EQ(fault([](S& s) { s.angle_min = 1.0, s.angle_max = -1.0, s.angle_increment = -0.01; }), none);
  EXPECT_EQ(fault([](S& s) { s.angle_min = std::nan(""); }), bad_angles);
  EXPECT_EQ(fault([](S& s) { s.angle_min = -13.0, s.angle_max = -11.0; }), bad_angles);
  for (const double step : {0.0, 9e-5, 0.51, -0.51, std::nan("")})
    EXPECT_EQ(fault([&](S& s) { s.angle_increment = step; }), bad_angles) << step;
  for (const double limit : {0.0, -1.0, 2e4, std::nan("")})
    EXPECT_EQ(fault([&](S& s) { s.range_max = limit; }), bad_limits) << limit;
  EXPECT_EQ(fault([](S& s) { s.range_min = -0.1; }), bad_limits);
  EXPECT_EQ(fault([](S& s) { s.X_FL.theta = std::nan(""); }), bad_pose);
  EXPECT_EQ(fault([](S& s) { s.X_FL.x = 2e6; }), bad_pose);

  // angle_max may be one step off either way, not two; without it any number will do from two up to a
  // revolution.
  EXPECT_EQ(fault([&](S& s) { s.ranges = beams(200); }), none);
  EXPECT_EQ(fault([&](S& s) { s.ranges = beams(202); }), none);
  EXPECT_EQ(fault([&](S& s) { s.ranges = beams(199); }), wrong_length);
  EXPECT_EQ(fault([&](S& s) { s.ranges = beams(203); }), wrong_length);
  EXPECT_EQ(fault([](S& s) { s.angle_increment = -0.01; }), wrong_length);
  EXPECT_EQ(fault([](S& s) { s.angle_max = std::nan(""); }), wrong_length);
  const auto unbound = [&](std::size_t count) {
    return fault(
        [&](S& s) { s.ranges = beams(count), s.angle_max.reset(), s.angle_increment = kTwoPi / 360; });
  };
  EXPECT_EQ(unbound(0), wrong_length);
  EXPECT_EQ(unbound(1), wrong_length);
  EXPECT_EQ(unbound(2), none);
  EXPECT_EQ(unbound(362), none);  // 361 steps: the first beam once more, and one
  EXPECT_EQ(unbound(364), wrong_length);
}

}  // namespace
}  // namespace bw
