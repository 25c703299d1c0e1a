// Stamps of the board on the component clock: delays, drift, wraps, jumps.
#include "components/robot_base/kobuki/board_clock.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace bw::kobuki {
namespace {

constexpr Time kStart = Time{1'000'000'000'000};

Time after(double milliseconds) { return kStart + Duration{std::llround(milliseconds * 1e6)}; }

/// One packet alone.
double time_ms(BoardClock& clock, double arrival_ms, int stamp) {
  const std::array<std::uint16_t, 1> stamps = {static_cast<std::uint16_t>(stamp)};
  return static_cast<double>((clock.times(after(arrival_ms), stamps).front() - kStart).nanoseconds) * 1e-6;
}

TEST(KobukiBoardClock, TheLeastDelayedPacketSaysWhatIsAdded) {
  BoardClock clock;
  EXPECT_NEAR(time_ms(clock, 30.0, 1000), 30.0, 0.01);
  EXPECT_NEAR(time_ms(clock, 45.0, 1020), 45.0,
              0.1);  // 15 ms after one of 20 ms: the first had come 5 ms late
  EXPECT_NEAR(time_ms(clock, 90.0, 1040), 65.0, 0.1);  // late by 25 ms: its time is not
  EXPECT_NEAR(time_ms(clock, 90.0, 1060), 85.0, 0.1);
}

// 200 s, three wraps of 65.536 s; the board's clock is fast or slow by 100 ppm; packets are 2 ms on the line,
// one in five is late by up to 40 ms, and the host looks every 10 ms. So a time is later than the truth by 2
// ms to 2 + 10 ms, and by what the offset rises until a packet is not late.
TEST(KobukiBoardClock, FollowsAClockThatDriftsThroughWrapsAndDelays) {
  for (const double drift : {1e-4, -1e-4}) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    BoardClock clock;
    double newest = -1.0, worst = 0.0, least = 1e9, looked = 0.0;
    std::vector<std::uint16_t> stamps;
    std::vector<double> truths;
    double arrived = 0.0;
    for (int i = 0; i < 10'000; ++i) {
      const double truth = 20.0 * i / (1.0 + drift);
      const double delay = 2.0 + (chance(random) < 0.2 ? 40.0 * chance(random) : 0.0);
      const double arrival = std::max(arrived, truth + delay);  // none overtakes another
      if (std::ceil(arrival / 10.0) * 10.0 > looked && !stamps.empty()) {
        const std::vector<Time> times = clock.times(after(looked), stamps);
        for (std::size_t k = 0; k < times.size(); ++k) {
          const double time = static_cast<double>((times[k] - kStart).nanoseconds) * 1e-6;
          ASSERT_GT(time, newest);
          newest = time;
          if (truths[k] < 2000.0) continue;
          worst = std::max(worst, time - truths[k]);
          least = std::min(least, time - truths[k]);
        }
        stamps.clear();
        truths.clear();
      }
      arrived = arrival;
      looked = std::ceil(arrival / 10.0) * 10.0;
      stamps.push_back(static_cast<std::uint16_t>(65'000 + 20 * i));
      truths.push_back(truth);
    }
    EXPECT_EQ(clock.jumps(), 0U) << drift;
    EXPECT_GT(least, 1.0) << drift;
    EXPECT_LT(worst, 13.0) << drift;
  }
}

// What a busy host reads together was measured 20 ms apart.
TEST(KobukiBoardClock, WhatWasHeldBackKeepsItsTimes) {
  BoardClock clock;
  for (int i = 0; i < 50; ++i) time_ms(clock, 20.0 * i, 20 * i);
  const std::array<std::uint16_t, 3> late = {1000, 1020, 1040};
  const std::vector<Time> times = clock.times(after(1400.0), late);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(static_cast<double>((times[static_cast<std::size_t>(i)] - kStart).nanoseconds) * 1e-6,
                1000.0 + 20.0 * i, 0.5);
  EXPECT_EQ(clock.jumps(), 0U);
}

TEST(KobukiBoardClock, AfterALongSilenceWrapsAreThoseThatFitTheArrivals) {
  BoardClock clock;
  time_ms(clock, 0.0, 100);
  // 200 s later: 100 + 200000 = 200100, modulo 65536 is 3492.
  EXPECT_NEAR(time_ms(clock, 200'000.0, 3492), 200'000.0, 21.0);
  EXPECT_EQ(clock.jumps(), 0U);
}

TEST(KobukiBoardClock, AClockThatJumpsIsCountedOnceAndBegunAnew) {
  for (const double jump : {-30'000.0, -150.0, 300.0, 5'000.0, 3'600'000.0}) {
    BoardClock clock;
    for (int i = 0; i < 100; ++i) time_ms(clock, 20.0 * i, 20 * i);
    double time = 0.0;
    for (int i = 100; i < 300; ++i) time = time_ms(clock, 20.0 * i + jump, 20 * i);
    EXPECT_EQ(clock.jumps(), 1U) << jump;
    EXPECT_NEAR(time, 20.0 * 299 + jump, 1.0) << jump;
  }
}

// The stamp falls from 2000 to 40.
TEST(KobukiBoardClock, ABoardThatRestartsIsAJump) {
  BoardClock clock;
  for (int i = 0; i < 100; ++i) time_ms(clock, 20.0 * i, 20 * i);
  EXPECT_NEAR(time_ms(clock, 2000.0, 40), 2000.0, 0.1);
  EXPECT_EQ(clock.jumps(), 1U);
}

}  // namespace
}  // namespace bw::kobuki
