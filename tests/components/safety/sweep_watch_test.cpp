#include "components/safety/sweep_watch.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace bw::safety {
namespace {

const Duration kTimeout = Duration::milliseconds(250);

std::vector<float> ranges(int seed) { return {1.0F + 0.001F * static_cast<float>(seed), 2.0F, 3.0F}; }

Time at(double seconds) { return Time::seconds(seconds); }

TEST(SweepWatch, IsSilentAQuarterSecondAfterTheLastSweep) {
  SweepWatch watch(kTimeout);
  EXPECT_EQ(watch.state(at(0.0)), LaserState::waiting);
  for (int i = 0; i < 5; ++i)
    EXPECT_TRUE(watch.add(at(0.1 * i), at(0.1 * i), ranges(i), SweepFault::none, {}));
  EXPECT_EQ(watch.state(at(0.64)), LaserState::ok);
  EXPECT_EQ(watch.state(at(0.66)), LaserState::silent);
  EXPECT_TRUE(watch.add(at(0.9), at(0.9), ranges(9), SweepFault::none, {}));
  EXPECT_EQ(watch.state(at(0.9)), LaserState::ok);
}

TEST(SweepWatch, EqualRangesAreFrozenOnlyWhenTheRobotMoves) {
  SweepWatch watch(kTimeout);
  for (int i = 0; i < 20; ++i) {  // at rest
    watch.add(at(0.1 * i), at(0.1 * i), ranges(0), SweepFault::none, {});
    EXPECT_EQ(watch.state(at(0.1 * i)), LaserState::ok);
  }
  // 0.1 m/s: 1 cm after 0.1 s; the last sweep that counts is the first of the drive or the one after it
  double frozen_at = 0.0;
  for (int i = 0; i < 20 && frozen_at == 0.0; ++i) {
    const double t = 2.0 + 0.1 * i;
    watch.add(at(t), at(t), ranges(0), SweepFault::none, {0.01 * i, 0.0, 0.0});
    if (watch.state(at(t)) == LaserState::frozen) frozen_at = t;
  }
  EXPECT_GT(frozen_at, 2.0);
  EXPECT_LE(frozen_at, 2.5);
}

TEST(SweepWatch, TurningCountsAsMoving) {
  SweepWatch watch(kTimeout);
  for (int i = 0; i < 6; ++i)
    watch.add(at(0.1 * i), at(0.1 * i), ranges(0), SweepFault::none, {0.0, 0.0, 0.05 * i});
  EXPECT_EQ(watch.state(at(0.5)), LaserState::frozen);
}

TEST(SweepWatch, TheSameMessageOverAndOverIsFrozen) {
  SweepWatch watch(kTimeout);
  for (int i = 0; i < 6; ++i) watch.add(at(0.1 * i), at(0.0), ranges(i), SweepFault::none, {});
  EXPECT_EQ(watch.state(at(0.5)), LaserState::frozen);
}

TEST(SweepWatch, OneUnsoundSweepIsBridgedAndManyAreNot) {
  SweepWatch watch(kTimeout);
  watch.add(at(0.0), at(0.0), ranges(0), SweepFault::none, {});
  EXPECT_FALSE(watch.add(at(0.1), at(0.1), ranges(1), SweepFault::wrong_length, {}));
  EXPECT_EQ(watch.state(at(0.2)), LaserState::ok);
  watch.add(at(0.2), at(0.2), ranges(2), SweepFault::no_returns, {});
  watch.add(at(0.3), at(0.3), ranges(3), SweepFault::no_returns, {});
  EXPECT_EQ(watch.state(at(0.3)), LaserState::invalid);
  EXPECT_EQ(watch.state(at(0.6)), LaserState::silent);
}

TEST(SweepWatch, AClockThatJumpsBackCostsOneSweep) {
  SweepWatch watch(kTimeout);
  watch.add(at(0.0), at(100.0), ranges(0), SweepFault::none, {});
  EXPECT_FALSE(watch.add(at(0.1), at(3.0), ranges(1), SweepFault::none, {}));
  EXPECT_TRUE(watch.add(at(0.2), at(3.1), ranges(2), SweepFault::none, {}));
}

TEST(SweepWatch, AnEmptyFloorIsNotFrozen) {
  const std::vector<float> nothing(3, std::numeric_limits<float>::infinity());
  SweepWatch watch(kTimeout);
  for (int i = 0; i < 10; ++i)
    watch.add(at(0.1 * i), at(0.1 * i), nothing, SweepFault::none, {0.1 * i, 0.0, 0.0});
  EXPECT_EQ(watch.state(at(0.9)), LaserState::ok);
}

}  // namespace
}  // namespace bw::safety
