// Ages of stamps: own clock, another clock, drift, steps, queues, messages that overtake one another.
#include "runtime/base/stamp_age.hpp"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace bw {
namespace {

constexpr Time kStart{1'000'000'000'000};
constexpr Duration kLimit = Duration::milliseconds(250);
constexpr Duration kHour = Duration::milliseconds(3'600'000);

Duration ms(double milliseconds) { return Duration::seconds(milliseconds * 1e-3); }
Time at(double seconds) { return kStart + Duration::seconds(seconds); }

/// A sensor at 10 Hz, its clock `offset` after ours and `drift` faster.
struct Sensor {
  StampAges ages;
  StampSource source{.is_own_clock = false};
  Duration offset = kHour * 3;
  double drift = 0.0;

  Time stamp(double seconds) const { return at(seconds * (1.0 + drift)) + offset; }
  /// What was measured at `measured` [s] arrives at `arrival` [s].
  StampAge add(double measured, double arrival) {
    return ages.add(at(arrival), source.is_own_clock ? at(measured) : stamp(measured), source, kLimit);
  }
  /// Sound samples from `from` to `to` [s], each `delay` [s] late; how many were believed.
  int run(double from, double to, double delay = 0.01) {
    int believed = 0;
    for (int i = static_cast<int>(std::lround(from * 10)); i < static_cast<int>(std::lround(to * 10)); ++i) {
      const StampAge seen = add(0.1 * i, 0.1 * i + delay);
      believed += seen.fault == StampFault::none;
      steps += seen.has_stepped;
    }
    return believed;
  }
  int steps = 0;
};

Sensor own() { return {.source = {}}; }

TEST(StampAge, OfTheOwnClockIsTrueAndAConstantDelayIsInIt) {
  Sensor sensor = own();
  EXPECT_EQ(sensor.add(1.0, 1.125).age, ms(125));
  EXPECT_EQ(sensor.add(1.1, 1.35).fault, StampFault::none);
  const StampAge late = sensor.add(1.2, 1.46);
  EXPECT_EQ(late.fault, StampFault::late);
  EXPECT_EQ(late.age, ms(260));
  EXPECT_EQ(sensor.add(1.53, 1.5).fault, StampFault::none);  // the tolerance is 50 ms
  EXPECT_EQ(sensor.add(1.66, 1.6).fault, StampFault::future);
  EXPECT_EQ(sensor.add(1.65, 1.7).fault, StampFault::none);  // the one of the future is forgotten
}

TEST(StampAge, WhatWasOvertakenIsTold) {
  for (const bool is_own : {true, false}) {
    Sensor sensor{.source = {.is_own_clock = is_own}};
    sensor.run(0.0, 5.0);
    EXPECT_EQ(sensor.add(5.1, 5.11).fault, StampFault::none);
    EXPECT_EQ(sensor.add(5.0, 5.12).fault, StampFault::overtaken) << is_own;
    EXPECT_EQ(sensor.add(5.2, 5.21).fault, StampFault::none);
    EXPECT_EQ(sensor.add(5.2, 5.22).fault, StampFault::none) << "twice is no fault of a stamp";
    const StampAge old = sensor.add(3.2, 5.25);  // 2 s late
    EXPECT_EQ(old.fault, StampFault::overtaken);
    EXPECT_NEAR(old.age.to_seconds(), is_own ? 2.05 : 2.04, 2e-3);
    EXPECT_EQ(sensor.run(5.3, 8.0), 27) << is_own;
    EXPECT_EQ(sensor.steps, 0);
  }
}

TEST(StampAge, OfAnotherClockGrowsFromTheLeastAfterASecondOfProof) {
  Sensor sensor;
  sensor.source.delay = ms(30);
  EXPECT_EQ(sensor.run(0.0, 1.0), 0);
  EXPECT_EQ(sensor.run(1.0, 3.0), 20);
  const StampAge seen = sensor.add(3.0, 3.11);  // 100 ms later than the others, which are 30 ms old
  EXPECT_NEAR(seen.age.to_seconds(), 0.130, 1e-3);
  EXPECT_EQ(sensor.add(3.1, 3.35).fault, StampFault::late);
}

// A queue of 3 s at the beginning: the first of it say that they are new. 3 s at 8 % a second more than come
// in: 37 s.
TEST(StampAge, AQueueAtTheBeginningIsNotBelievedUntilItIsEmpty) {
  Sensor sensor;
  double arrival = 3.0, measured = 0.0;
  for (; arrival - measured > 0.02; measured += 0.1, arrival += 0.1 / 1.08) {
    const StampAge seen = sensor.add(measured, arrival);
    EXPECT_NE(seen.fault, StampFault::none) << arrival - measured;
  }
  EXPECT_GE(sensor.run(std::ceil(measured * 10.0) * 0.1 + 0.2, measured + 3.0), 15);
}

TEST(StampAge, AQueueThatEmptiesIsOldUntilItIsEmpty) {
  for (const bool is_own : {true, false}) {
    Sensor sensor{.source = {.is_own_clock = is_own}};
    sensor.run(0.0, 10.0);
    // Nothing for 2 s, then 20 sweeps 1 ms apart, the newest 20 ms old.
    for (int i = 0; i < 20; ++i) {
      const double measured = 10.0 + 0.1 * i, arrival = 11.91 + 0.001 * i;
      const StampAge seen = sensor.add(measured, arrival);
      const double age = arrival - measured - (is_own ? 0.0 : 0.01);
      EXPECT_NEAR(seen.age.to_seconds(), age, 1.1e-3);
      EXPECT_EQ(seen.fault, age > 0.25 ? StampFault::late : StampFault::none) << age;
    }
    EXPECT_EQ(sensor.run(12.0, 15.0), 30);
    EXPECT_EQ(sensor.steps, 0);
  }
}

// A queue that stays: 0.5 s, for an hour. An age that a window forgets would be new again after the window.
TEST(StampAge, WhatStaysLateIsLateForEver) {
  Sensor sensor;
  sensor.run(0.0, 10.0);
  EXPECT_EQ(sensor.run(11.0, 3600.0, 0.51), 0);
  EXPECT_NEAR(sensor.add(3600.0, 3600.51).age.to_seconds(), 0.5, 2e-3);
  EXPECT_EQ(sensor.run(3601.0, 3602.0), 10);  // and new again when it is
}

// 200 ms more in 100 s are no clock: what 500 ppm explain, and the 50 ms that count as near, are missed.
TEST(StampAge, ADelayThatGrowsIsNotTakenForDrift) {
  Sensor sensor;
  sensor.run(0.0, 10.0);
  StampAge seen;
  for (int i = 0; i < 1000; ++i) seen = sensor.add(10.0 + 0.1 * i, 10.01 + 0.1 * i + 0.0002 * i);
  EXPECT_GT(seen.age.to_seconds(), 0.2 - 0.05);
  EXPECT_LE(seen.age.to_seconds(), 0.2);
}

TEST(StampAge, AnHourOfDriftOf500PpmWithJitterCostsNothing) {
  for (const double drift : {5e-4, -5e-4}) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> jitter(0.0, 0.02);
    Sensor sensor{.drift = drift};
    double worst = 0.0;
    for (int i = 0; i < 36'000; ++i) {
      const double delay = jitter(random);
      const StampAge seen = sensor.add(0.1 * i, 0.1 * i + delay);
      if (i < 100) continue;
      ASSERT_EQ(seen.fault, StampFault::none) << i;
      worst = std::max(worst, std::abs(seen.age.to_seconds() - delay));
    }
    EXPECT_LT(worst, 0.006) << drift;  // the least is seen again within 4 s
  }
}

// Steps are of no whole period: a stamp that came before is no news.
TEST(StampAge, AClockThatIsSetIsToldOnceAndBelievedAfterASecond) {
  for (const double step : {3600.001, -3600.001, 0.301, -0.301, 5.001, -5.001}) {
    Sensor sensor;
    sensor.run(0.0, 10.0);
    sensor.offset = sensor.offset + Duration::seconds(step);
    EXPECT_EQ(sensor.run(10.0, 11.0), 0) << step;
    EXPECT_GE(sensor.run(11.0, 20.0), 89) << step;
    EXPECT_EQ(sensor.steps, 1) << step;
    EXPECT_NEAR(sensor.add(20.0, 20.11).age.to_seconds(), 0.1, 1e-3) << step;
  }
  for (const double step : {0.001, -0.001, 0.015, -0.015}) {
    Sensor sensor;
    sensor.run(0.0, 10.0);
    sensor.offset = sensor.offset + Duration::seconds(step);
    EXPECT_EQ(sensor.run(10.0, 20.0), 100) << step;
    EXPECT_EQ(sensor.steps, 0);
  }
}

// The clock is set back while a queue of 2 s empties, more slowly than 20 ms a second never: nothing of it is
// taken for new.
TEST(StampAge, AStepWhileAQueueEmptiesIsNotBelievedBeforeItIsEmpty) {
  for (const double step : {0.301, -0.301, 3600.001, -3600.001}) {
    Sensor sensor;
    sensor.run(0.0, 10.0);
    double arrival = 12.0, measured = 10.0;
    for (; arrival - measured > 0.06; measured += 0.1, arrival += 0.08) {
      if (measured > 10.45) sensor.offset = kHour * 3 + Duration::seconds(step);
      const double true_age = arrival - measured;
      const StampAge seen = sensor.add(measured, arrival);
      // What was set forward by less than the queue hides so much of it.
      const double hidden = step == 0.301 ? 0.301 : 0.0;
      if (seen.fault == StampFault::none) {
        EXPECT_LT(true_age - seen.age.to_seconds(), hidden + 0.03) << step << " " << true_age;
      }
    }
  }
}

// 0.2 s late for 3 s, then the clock is set by whatever: it is still 0.2 s late.
TEST(StampAge, WhatWasLateBeforeAClockWasSetIsAsLateAfterIt) {
  for (const double step : {3600.001, -3600.001, 0.301, -0.301}) {
    Sensor sensor;
    sensor.run(0.0, 10.0);
    sensor.run(10.0, 13.0, 0.21);
    sensor.offset = sensor.offset + Duration::seconds(step);
    sensor.run(13.0, 20.0, 0.21);
    EXPECT_EQ(sensor.steps, 1) << step;
    EXPECT_NEAR(sensor.add(20.0, 20.21).age.to_seconds(), 0.2, 5e-3) << step;
    EXPECT_NEAR(sensor.add(20.1, 20.11).age.to_seconds(), 0.0, 5e-3) << step;
  }
}

// Another way through the network takes over, half a second late: what comes there was seen before, and the
// rest stays late.
TEST(StampAge, WhatComesAgainOnASlowerWayIsNoStep) {
  Sensor sensor;
  sensor.run(0.0, 10.0);
  EXPECT_EQ(sensor.run(9.5, 30.0, 0.51), 0);
  EXPECT_EQ(sensor.steps, 0);
}

TEST(StampAge, AfterALongSilenceAClockThatWasSetIsProvenAnew) {
  Sensor sensor;
  sensor.run(0.0, 10.0);
  EXPECT_EQ(sensor.run(600.0, 610.0), 100);  // it was not
  sensor.offset = sensor.offset - Duration::milliseconds(900);
  EXPECT_EQ(sensor.run(630.0, 631.0), 0);
  EXPECT_EQ(sensor.run(631.0, 640.0), 90);
  EXPECT_EQ(sensor.steps, 1);
}

TEST(StampAge, AComponentClockThatGoesBackBeginsAnew) {
  Sensor sensor = own();
  sensor.run(100.0, 110.0);
  EXPECT_EQ(sensor.run(0.0, 10.0), 100);
}

TEST(StampAge, WritersAreToldApartAndTheirNumberIsBounded) {
  StampAges ages;
  const auto add = [&](std::uint8_t writer, double seconds, double offset) {
    return ages.add(at(seconds), at(seconds + offset), {.writer = {writer}, .is_own_clock = false}, kLimit)
        .fault;
  };
  for (int i = 0; i < 20; ++i) {
    add(1, 0.1 * i, 0.0);
    add(2, 0.1 * i, 1000.0);
  }
  EXPECT_EQ(add(1, 2.0, 0.0), StampFault::none);
  EXPECT_EQ(add(2, 2.0, 1000.0), StampFault::none);
  for (std::uint8_t other = 10; other < 25; ++other) add(other, 2.1 + 0.001 * other, 0.0);
  EXPECT_EQ(add(2, 2.2, 1000.0), StampFault::none);
  EXPECT_EQ(add(1, 2.2, 0.0), StampFault::unproven);  // sixteen others came since
}

// Whatever comes, an age is not believed that is far too young: random delays, queues, drifts and stalls,
// without steps.
TEST(StampAge, RandomQueuesAreNeverTakenForNew) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> chance(0.0, 1.0);
  for (int trial = 0; trial < 2000; ++trial) {
    Sensor sensor{.drift = 1e-3 * (chance(random) - 0.5)};
    const double rate = 4.0 + 36.0 * chance(random);
    double arrived = 0.0, extra = 0.0;
    double least = 1e9;
    for (int i = 0; i < 600; ++i) {
      if (chance(random) < 0.02) extra = 3.0 * chance(random);  // a stall, or its end
      if (chance(random) < 0.02) extra = 0.0;
      const double measured = i / rate;
      const double arrival = std::max(arrived + 1e-4, measured + extra + 0.005 * chance(random));
      arrived = arrival;
      least = std::min(least, arrival - measured);
      const StampAge seen = sensor.add(measured, arrival);
      ASSERT_FALSE(seen.has_stepped && least < 1e-9);
      if (seen.fault != StampFault::none) continue;
      ASSERT_GT(seen.age.to_seconds(), arrival - measured - least - 0.06)
          << "trial " << trial << " sample " << i;
    }
  }
}

}  // namespace
}  // namespace bw
