// Old sweeps: a robot drives at 1 m/s towards a wall, and what its laser says comes late. It stands before
// the wall, or does not drive and says why. What cannot be seen is asserted too: the constant delay of
// another clock that nobody declared.
#include <cmath>
#include <deque>
#include <functional>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "components/safety/collision_monitor.hpp"
#include "tests/components/safety/sweeps.hpp"

namespace bw::safety {
namespace {

constexpr double kStep = 0.01;  // [s]
constexpr double kWall = 10.0;  // [m]
constexpr double kStart = 3.0;  // [s] when the command comes
constexpr double kFault = 5.0;  // [s] when faults begin: at full speed, 8 m before the wall

using OverTime = std::function<double(double)>;

OverTime constant(double value) {
  return [=](double) { return value; };
}

struct Case {
  double rate = 10.0;
  OverTime delay = constant(0.0);  ///< of what was measured at t [s]; nothing overtakes
  OverTime clock = constant(0.0);  ///< what the stamp is ahead of our clock [s]
  StampSource source{};
};

struct Outcome {
  double gap = 0.0;     ///< at the end [m]
  double impact = 0.0;  ///< speed at the wall [m/s]
  std::set<std::string> causes;
};

/// Straight towards a wall that fills the view.
Sweep wall_at(double distance) {
  constexpr int kBeams = 121;
  Sweep sweep{{.angle_min = -0.8,
               .angle_increment = 1.6 / (kBeams - 1),
               .range_min = 0.05,
               .range_max = 40.0,
               .angle_max = 0.8},
              std::vector<float>(kBeams)};
  for (int i = 0; i < kBeams; ++i)
    sweep.ranges[static_cast<std::size_t>(i)] =
        static_cast<float>(std::max(distance, 0.06) / std::cos(sweep.angle_min + i * sweep.angle_increment));
  return sweep;
}

/// A disc of 0.3 m that follows the monitor with 1 m/s^2 and brakes with 2 m/s^2.
Outcome drive(const Case& c, double phase = 0.0) {
  struct InTransit {
    double arrival, measured, x;
  };
  CollisionMonitor monitor{Robot{}, {}};
  std::deque<InTransit> queue;
  Outcome outcome;
  double x = 0.0, v = 0.0, next = phase, last_arrival = 0.0;
  const double base = 1000.0;
  Verdict verdict;
  for (int i = 0; i < 2500; ++i) {
    const double t = i * kStep;
    if (t >= next) {
      last_arrival = std::max(last_arrival, t + c.delay(t));
      queue.push_back({last_arrival, t, x});
      next += 1.0 / c.rate;
    }
    const Time now = Time::seconds(base + t);
    if (i % 2 == 0) monitor.odometry(now, {x, 0.0, 0.0}, {v, 0.0});
    for (; !queue.empty() && queue.front().arrival <= t + 1e-9; queue.pop_front()) {
      const InTransit& one = queue.front();
      Sweep sweep = wall_at(kWall - one.x);
      sweep.time = Time::seconds(base + one.measured + c.clock(one.measured));
      monitor.sweep(now, sweep.view(), c.source);
    }
    if (i % 2 == 0) verdict = monitor.judge(now, {t >= kStart ? 1.0 : 0.0, 0.0});
    if (t >= kStart && verdict.action != Action::do_nothing)
      outcome.causes.insert(std::string(verdict.cause) +
                            (verdict.cause == kLaserInvalid ? to_text(monitor.stamp().fault) : ""));
    v = std::clamp(verdict.allowed.v, v - 2.0 * kStep, v + 1.0 * kStep);
    x += v * kStep;
    if (x + 0.3 > kWall) outcome.impact = v;
    if (x + 0.3 > kWall || (v == 0.0 && x + 0.3 > kWall - 0.11)) break;
  }
  outcome.gap = kWall - 0.3 - x;
  return outcome;
}

constexpr StampSource kOther{.is_own_clock = false};

/// All phases of the sweep end before the wall.
void stands(const Case& c, const std::string& what) {
  for (int i = 0; i < 3; ++i) {
    const Outcome outcome = drive(c, i / c.rate / 3.0);
    EXPECT_EQ(outcome.impact, 0.0) << what << ", phase " << i;
    EXPECT_GT(outcome.gap, 0.05) << what << ", phase " << i;
    if (outcome.gap > 0.3) {
      EXPECT_FALSE(outcome.causes.empty()) << what << ", stands far off and says nothing";
    }
  }
}

// Before the mend: 0.19 s stood, 0.21 s touched at 0.41 m/s, 0.5 s at 1.00 m/s.
TEST(SweepAge, OfTheOwnClockEveryConstantAgeStandsOrIsRefused) {
  for (int i = 0; i <= 20; ++i) {
    const double age = 0.05 * i;
    stands({.delay = constant(age)}, "age " + std::to_string(age));
    stands({.rate = 5.0, .delay = constant(age)}, "5 Hz, age " + std::to_string(age));
    const Outcome outcome = drive({.delay = constant(age)});
    // Up to source_timeout it drives up to the wall; what is older is refused, and it never sets off.
    if (age < 0.24) {
      EXPECT_NEAR(outcome.gap, 0.1, 0.06) << age;
    } else if (age > 0.26) {
      EXPECT_EQ(outcome.gap, kWall - 0.3) << age;
      EXPECT_TRUE(outcome.causes.contains("laser_invalidlate")) << age;
    }
  }
}

TEST(SweepAge, OfAnotherClockADeclaredDelayCountsAndOneThatIsNotIsUnseen) {
  for (int i = 0; i <= 20; ++i) {
    const double age = 0.05 * i;
    const StampSource declared{.is_own_clock = false, .delay = Duration::seconds(age)};
    for (const double ahead : {-3600.0, 0.0, 3600.0})
      stands({.delay = constant(age), .clock = constant(ahead), .source = declared},
             "age " + std::to_string(age));
  }
  EXPECT_GT(drive({.delay = constant(0.5), .source = kOther}).impact, 0.3);
}

TEST(SweepAge, ADelayThatBeginsOrGrowsOrAQueueThatEmpties) {
  for (const StampSource& source : {StampSource{}, kOther}) {
    const std::string whose = source.is_own_clock ? "own" : "other";
    for (int i = 0; i <= 20; ++i) {
      const double age = 0.05 * i;
      const auto begins = [=](double t) { return t > kFault ? age : 0.0; };
      stands({.delay = begins, .source = source}, whose + " begins " + std::to_string(age));
      const auto grows = [=](double t) { return t > kFault ? age * (t - kFault) / 5.0 : 0.0; };
      stands({.delay = grows, .source = source}, whose + " grows " + std::to_string(age));
      // Held back for 2 s before the wall, then all at once.
      const auto burst = [=](double t) { return t > 8.0 + age && t < 10.0 + age ? 10.0 + age - t : 0.0; };
      stands({.delay = burst, .source = source}, whose + " burst " + std::to_string(age));
      // Held back, and then given out no faster than they come: it stays late.
      const auto stays = [=](double t) { return t > 8.0 + age ? 2.0 : 0.0; };
      stands({.delay = stays, .source = source}, whose + " stays " + std::to_string(age));
    }
  }
}

TEST(SweepAge, StepsOfAnotherClock) {
  for (const double step : {3600.0, -3600.0, 0.001, -0.001, 0.3, -0.3, 0.3137, -0.3137, 0.15, -0.15}) {
    for (const double late : {0.0, 0.1, 0.2}) {
      // Set forward by less than the sweeps are late: nothing tells that from a queue that empties.
      if (step > 0.01 && step < late) continue;
      for (const double at : {6.0, 9.0, 10.5, 11.2}) {
        const auto clock = [=](double t) { return t > at ? step : 0.0; };
        const auto delay = [=](double t) { return t > 7.0 ? late : 0.0; };
        stands(
            {.delay = delay, .clock = clock, .source = kOther},
            "step " + std::to_string(step) + " late " + std::to_string(late) + " at " + std::to_string(at));
      }
    }
  }
}

// For an hour the robot stands, then drives; the laser's clock is fast or slow by 500 ppm meanwhile.
TEST(SweepAge, AnHourOfDrift) {
  for (const double drift : {5e-4, -5e-4}) {
    CollisionMonitor monitor{Robot{}, {}};
    Sweep sweep = wall_at(5.0);
    for (int i = 0; i < 36'000; ++i) {
      const double t = 1000.0 + 0.1 * i;
      const double delay = i % 7 == 0 ? 0.0 : 0.03;
      if (i % 10 != 0 && i < 35'000) continue;  // once a second will do for most of it
      monitor.odometry(Time::seconds(t + delay), {}, {});
      sweep.ranges[0] += 1e-4F;
      sweep.time = Time::seconds(t * (1.0 + drift) + 77.0);
      monitor.sweep(Time::seconds(t + delay), sweep.view(), kOther);
      if (i < 30) continue;
      ASSERT_EQ(monitor.stamp().fault, StampFault::none) << t;
      ASSERT_NEAR(monitor.stamp().age.to_seconds(), delay, 0.01) << t;
    }
  }
}

// Row 13 of the faults: out of order, twice, and 2 s late, all the way.
TEST(SweepAge, OutOfOrderTwiceAndLate) {
  for (const StampSource& source : {StampSource{}, kOther}) {
    CollisionMonitor monitor{Robot{}, {}};
    Sweep sweep = wall_at(1.0);
    Sweep old = wall_at(5.0);
    double now = 1000.0;
    const auto give = [&](Sweep& s, double measured, double arrival) {
      s.ranges[0] += 1e-4F;
      s.time = Time::seconds(measured);
      monitor.odometry(Time::seconds(arrival), {}, {});
      monitor.sweep(Time::seconds(arrival), s.view(), source);
    };
    for (int i = 0; i < 30; ++i, now += 0.1) give(sweep, now, now);
    const double allowed = monitor.judge(Time::seconds(now - 0.1), {1.0, 0.0}).allowed.v;
    for (int i = 0; i < 30; ++i, now += 0.1) {
      give(sweep, now, now);
      give(old, now - 0.15, now + 0.01);  // what it saw before the one before
      give(old, now - 2.0, now + 0.02);
      give(old, now, now + 0.03);  // the same stamp again
      EXPECT_LE(monitor.judge(Time::seconds(now + 0.04), {1.0, 0.0}).allowed.v, allowed + 1e-3)
          << "own " << source.is_own_clock << " " << i;
    }
  }
}

}  // namespace
}  // namespace bw::safety
