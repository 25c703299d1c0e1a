#include "components/safety/sweep.hpp"

#include <algorithm>
#include <cstring>
#include <functional>

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/safety/sweeps.hpp"

namespace bw::safety {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

CheckedSweep check(const Sweep& sweep, const SweepOptions& options = {}) {
  return check_sweep(sweep.view(), options);
}

SweepFault fault(const std::function<void(Sweep&)>& spoil) {
  Sweep sweep = sweep_of({});
  spoil(sweep);
  return check(sweep).fault;
}

TEST(Sweep, ASoundOneGivesItsPointsInBaseLink) {
  // A pole of 0.1 m at (2, 0.5) seen from a laser that sits at (0.2, 0) and looks left by 30 degrees
  const Pose2 X_BS{0.2, 0.0, std::numbers::pi / 6.0};
  const Vector2 pole_S = inverse(X_BS) * Vector2(2.0, 0.5);
  Sweep sweep = sweep_of({{pole_S, 0.1}}, kInfinity);
  sweep.X_FL = X_BS;
  const CheckedSweep out = check(sweep);
  ASSERT_EQ(out.fault, SweepFault::none);
  ASSERT_GE(out.points.size(), 10U);
  for (const SeenPoint& point : out.points) {
    EXPECT_NEAR((point.position - Vector2(2.0, 0.5)).norm(), 0.1, 1e-5);
    EXPECT_TRUE(point.is_narrow);
  }
}

TEST(Sweep, RefusesWhatMakesNoSense) {
  EXPECT_EQ(fault([](Sweep&) {}), SweepFault::none);
  EXPECT_EQ(fault([](Sweep& s) { s.angle_increment = 0.0; }), SweepFault::bad_angles);
  EXPECT_EQ(fault([](Sweep& s) { s.angle_min = std::nan(""); }), SweepFault::bad_angles);
  EXPECT_EQ(fault([](Sweep& s) { s.range_max = s.range_min; }), SweepFault::bad_limits);
  EXPECT_EQ(fault([](Sweep& s) { s.range_min = -1.0; }), SweepFault::bad_limits);
  EXPECT_EQ(fault([](Sweep& s) { s.angle_increment = 1e-9; }),
            SweepFault::bad_angles);  // 1e9 beams claimed
  EXPECT_EQ(fault([](Sweep& s) { s.angle_increment *= 2.0; }), SweepFault::wrong_length);
  EXPECT_EQ(fault([](Sweep& s) { s.ranges.resize(717); }), SweepFault::wrong_length);
  EXPECT_EQ(fault([](Sweep& s) { s.ranges.resize(5000, 3.0F); }), SweepFault::wrong_length);
  EXPECT_EQ(fault([](Sweep& s) { s.ranges.resize(200'000, 3.0F); }), SweepFault::wrong_length);
  EXPECT_EQ(fault([](Sweep& s) { s.ranges.clear(); }), SweepFault::wrong_length);
}

TEST(Sweep, ALostSweepIsNotAFreeOne) {
  for (const float value : {kNan, -kInfinity, 0.0F, -1.0F, 21.0F, 0.04F}) {
    EXPECT_EQ(fault([&](Sweep& s) { std::fill(s.ranges.begin(), s.ranges.end(), value); }),
              SweepFault::mostly_unknown)
        << value;
  }
}

TEST(Sweep, OneThatHitsNothingIsSoundAndFree) {
  const CheckedSweep out = check(sweep_of({}, kInfinity));
  EXPECT_EQ(out.fault, SweepFault::none);
  EXPECT_EQ(std::count(out.beams.begin(), out.beams.end(), BeamKind::free), 720);
  EXPECT_TRUE(out.points.empty());
}

TEST(Sweep, TenPercentOfUnusableBeamsHideNothing) {
  Random random(5);
  for (const float value : {kNan, kInfinity, -kInfinity, 0.0F, -2.0F}) {
    Sweep sweep = sweep_of({{{1.0, 0.0}, 0.07}});
    for (float& range : sweep.ranges) {
      if (random.uniform() < 0.1) range = value;
    }
    const CheckedSweep out = check(sweep);
    ASSERT_EQ(out.fault, SweepFault::none);
    const auto near = std::count_if(out.points.begin(), out.points.end(),
                                    [](const SeenPoint& p) { return p.position.norm() < 1.1; });
    EXPECT_GE(near, 12);  // 21 beams lie on the leg
    const Sight sight = sight_of(out, 0.0, 0.785);
    EXPECT_DOUBLE_EQ(sight.covered, 1.0);
    EXPECT_LT(sight.unknown, 0.2);
    EXPECT_LT(sight.widest_gap, 0.05);
  }
}

TEST(Sweep, LonelyReturnsDoNotCountAndThreeNeighboursDo) {
  Sweep sweep = sweep_of({});
  sweep.ranges[360] = 0.5F;
  sweep.ranges[362] = 0.7F;
  const auto nearest = [&] {
    double least = 100.0;
    for (const SeenPoint& p : check(sweep).points) least = std::min(least, p.position.norm());
    return least;
  };
  EXPECT_GT(nearest(), 7.9);
  sweep.ranges[361] = 0.52F;
  sweep.ranges[362] = 0.49F;
  EXPECT_NEAR(nearest(), 0.49, 1e-6);
}

TEST(Sweep, LegsAreNarrowAndWallsAreNot) {
  // A leg of 0.14 m, a pillar of 1 m, and the wall behind: everything else of the sweep
  const CheckedSweep out = check(sweep_of({{{1.5, 0.0}, 0.07}, {{0.0, 2.0}, 0.5}}, 6.0F));
  int legs = 0;
  for (const SeenPoint& p : out.points) {
    const bool is_leg = (p.position - Vector2(1.5, 0.0)).norm() < 0.1;
    EXPECT_EQ(p.is_narrow, is_leg) << p.position.transpose();
    legs += is_leg ? 1 : 0;
  }
  EXPECT_GE(legs, 10);
}

TEST(Sweep, SightIsLessWhereBeamsAreUnknownOrMissing) {
  Sweep sweep = sweep_of({});
  for (std::size_t i = 340; i < 380; ++i)
    sweep.ranges[i] = kNan;  // 40 beams of 0.376 degrees, straight ahead
  const CheckedSweep out = check(sweep);
  const Sight ahead = sight_of(out, 0.0, 0.785);
  EXPECT_NEAR(ahead.widest_gap, 40.0 * sweep.angle_increment, 1e-9);
  EXPECT_NEAR(ahead.unknown, 40.0 / 239.0, 0.002);  // 2 * 0.785 rad hold 239 beams
  EXPECT_EQ(sight_of(out, std::numbers::pi, 0.785).covered,
            0.0);  // the laser sees 135 degrees to either side
  EXPECT_NEAR(sight_of(out, std::numbers::pi / 2.0, 1.0).covered, 1.785 / 2.0, 0.01);
}

/// 360 degrees from the rear on, `blind` beams unknown at its beginning and at its end.
CheckedSweep all_round(int beams, int blind_first, int blind_last, double from = -std::numbers::pi) {
  CheckedSweep sweep{.angle_min = from, .angle_increment = 2.0 * std::numbers::pi / beams};
  sweep.beams.assign(static_cast<std::size_t>(beams), BeamKind::hit);
  for (int i = 0; i < blind_first; ++i) sweep.beams[static_cast<std::size_t>(i)] = BeamKind::unknown;
  for (int i = 0; i < blind_last; ++i)
    sweep.beams[static_cast<std::size_t>(beams - 1 - i)] = BeamKind::unknown;
  return sweep;
}

// A mast straight behind hides 10 degrees at either end of the sweep: one gap of 20 degrees, not two of 10.
// Rotated so that the ends lie elsewhere the same gap is as wide.
TEST(Sweep, TheEndsOfATurnAreOneDirection) {
  const double degree = std::numbers::pi / 180.0;
  EXPECT_NEAR(sight_of(all_round(720, 20, 20), std::numbers::pi, 0.785).widest_gap, 20.0 * degree, 1e-9);
  EXPECT_NEAR(sight_of(all_round(720, 20, 20), -std::numbers::pi, 0.785).widest_gap, 20.0 * degree, 1e-9);
  EXPECT_NEAR(sight_of(all_round(720, 40, 0), std::numbers::pi, 0.785).widest_gap, 20.0 * degree, 1e-9);
  EXPECT_NEAR(sight_of(all_round(720, 20, 20, 0.0), 0.0, 0.785).widest_gap, 20.0 * degree, 1e-9);
  EXPECT_EQ(sight_of(all_round(720, 20, 20), 0.0, 0.785).widest_gap, 0.0);
  CheckedSweep clockwise = all_round(720, 20, 20, std::numbers::pi);
  clockwise.angle_increment = -clockwise.angle_increment;
  EXPECT_NEAR(sight_of(clockwise, std::numbers::pi, 0.785).widest_gap, 20.0 * degree, 1e-9);
  // 350 degrees of beams, and 5 degrees unknown at either end: 20 degrees without sight behind.
  CheckedSweep part = all_round(720, 10, 10, -175.0 * degree);
  part.beams.erase(part.beams.begin() + 360, part.beams.begin() + 380);
  EXPECT_NEAR(sight_of(part, std::numbers::pi, 0.785).widest_gap, 20.0 * degree, 1e-9);
}

TEST(Sweep, RandomBytesNeitherCrashNorGivePointsThatAreNotFinite) {
  Random random(11);
  for (int i = 0; i < 3000; ++i) {
    Sweep sweep = sweep_of({});
    sweep.ranges.resize(random.bits() % 900);
    for (float& range : sweep.ranges) {
      const auto bits = static_cast<std::uint32_t>(random.bits());
      std::memcpy(&range, &bits, sizeof range);
    }
    if (i % 3 == 0) sweep.ranges.resize(720, 3.0F);
    if (i % 5 == 0) sweep.angle_increment = random.normal();
    const CheckedSweep out = check(sweep);
    for (const SeenPoint& p : out.points) ASSERT_TRUE(p.position.allFinite());
    EXPECT_TRUE(out.fault == SweepFault::none || out.points.empty());
  }
}

}  // namespace
}  // namespace bw::safety
