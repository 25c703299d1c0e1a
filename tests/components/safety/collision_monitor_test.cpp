#include "components/safety/collision_monitor.hpp"

#include <gtest/gtest.h>

#include "components/model/random.hpp"
#include "tests/components/safety/sweeps.hpp"

namespace bw::safety {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A wide pillar whose surface is `distance` [m] ahead of base_link.
Disc pillar(double distance) { return {{distance + 0.5, 0.0}, 0.5}; }

/// A robot at rest or at a steady speed, with a laser at 10 Hz and odometry at 50 Hz.
class Bench {
 public:
  explicit Bench(CollisionMonitorOptions options = {}) : monitor(robot(), options) {}

  static Robot robot() {
    Robot r;  // radius 0.3, 1 m/s, stop_deceleration 2 m/s^2
    return r;
  }
  /// The verdict after `seconds` of this sweep, with a little noise so that it is not frozen.
  Verdict run(double seconds, const Sweep& sweep, const Twist2& wanted, const Twist2& actual = {}) {
    Verdict verdict;
    for (int i = 0; i < static_cast<int>(std::lround(seconds / 0.02)); ++i) {
      now = now + Duration::milliseconds(20);
      monitor.odometry(now, {}, actual);
      if (cycle++ % 5 == 0 && laser_on) {
        Sweep seen = sweep;
        seen.time = now;
        for (float& range : seen.ranges) range += static_cast<float>(frozen ? 0.0 : 1e-4 * random.uniform());
        monitor.sweep(now, seen.view());
      }
      verdict = monitor.judge(now, wanted);
    }
    return verdict;
  }

  CollisionMonitor monitor;
  Random random{3};
  Time now = Time::seconds(10.0);
  int cycle = 0;
  bool laser_on = true;
  bool frozen = false;
};

TEST(CollisionMonitor, PassesOnWhatHasRoom) {
  Bench bench;
  const Verdict verdict = bench.run(0.2, sweep_of({}), {1.0, 0.3});
  EXPECT_EQ(verdict.allowed, (Twist2{1.0, 0.3}));
  EXPECT_EQ(verdict.action, Action::do_nothing);
  EXPECT_TRUE(verdict.cause.empty());
}

TEST(CollisionMonitor, TheStopEndsTenCentimetresBeforeWhatIsThere) {
  // Free distance 0.36 m, less 0.10 m: v 0.1 + v^2 / 4 = 0.26 gives v = -0.2 + sqrt(0.04 + 1.04) = 0.8392
  const Verdict verdict = Bench().run(0.1, sweep_of({pillar(0.66)}), {1.0, 0.0}, {0.0, 0.0});
  EXPECT_NEAR(verdict.allowed.v, 0.8392, 2e-3);
  EXPECT_EQ(verdict.action, Action::approach);
  EXPECT_EQ(verdict.cause, kStoppingDistance);
  EXPECT_EQ(Bench().run(0.1, sweep_of({pillar(0.76)}), {1.0, 0.0}).allowed.v, 1.0);
  EXPECT_EQ(Bench().run(0.1, sweep_of({pillar(0.40)}), {1.0, 0.0}).action, Action::stop);
}

// Free distance 1.0 m, less 0.10 m, less 0.08 m that it came nearer since the sweep: with u = 1 m/s
// v 0.1 + v^2 / 4 + (0.1 + v / 2) = 0.82 gives v = -1.2 + sqrt(1.44 + 4 * 0.72) = 0.8785
TEST(CollisionMonitor, WhatApproachesHasComeNearerSinceTheSweep) {
  CollisionMonitorOptions options;
  options.stopping.approach_speed = 1.0;
  const Verdict verdict = Bench(options).run(0.1, sweep_of({pillar(1.3)}), {1.0, 0.0});
  EXPECT_NEAR(verdict.allowed.v, 0.8785, 2e-3);
}

// Free distance 0.36 m, less 0.20 m: v 0.1 + v^2 / 4 = 0.16 gives v = -0.2 + sqrt(0.04 + 0.64) = 0.6246
TEST(CollisionMonitor, TakesOtherDistancesWhileItRuns) {
  Bench bench;
  const Sweep sweep = sweep_of({pillar(0.66)});
  EXPECT_NEAR(bench.run(0.1, sweep, {1.0, 0.0}).allowed.v, 0.8392, 2e-3);
  CollisionMonitorOptions options;
  options.stopping.margin = 0.2;
  bench.monitor.set_options(options);
  EXPECT_NEAR(bench.run(0.02, sweep, {1.0, 0.0}).allowed.v, 0.6246, 2e-3);
}

TEST(CollisionMonitor, TakesOtherZonesWhileItRuns) {
  CollisionMonitorOptions options;
  options.polygons.push_back(
      {.name = "wide", .radius = 1.0, .action_type = Action::limit, .linear_limit = 0.3});
  Bench bench(options);
  const Sweep sweep = sweep_of({pillar(0.9)});
  EXPECT_EQ(bench.run(0.1, sweep, {0.6, 0.0}).cause, "wide");
  options.polygons[0].linear_limit = 0.2;
  options.polygons[0].name = "a name that is long enough for memory of its own";
  bench.monitor.set_options(options);
  const Verdict verdict = bench.run(0.02, sweep, {0.6, 0.0});
  EXPECT_EQ(verdict.cause, options.polygons[0].name);
  EXPECT_NEAR(verdict.allowed.v, 0.2, 1e-9);
  options.polygons[0].enabled = false;
  bench.monitor.set_options(options);
  const Verdict held = bench.run(0.02, sweep, {0.6, 0.0});  // a limit is eased kClearAfter later
  EXPECT_EQ(held.cause, kStoppingDistance);
  EXPECT_NEAR(held.allowed.v, 0.2, 1e-9);
  EXPECT_EQ(bench.run(2.0, sweep, {0.6, 0.0}).allowed.v, 0.6);
}

TEST(CollisionMonitor, ScalesBothSoThatThePathStays) {
  const Twist2 wanted{1.0, 0.4};
  const Verdict verdict = Bench().run(0.1, sweep_of({pillar(0.7)}), wanted);
  EXPECT_LT(verdict.allowed.v, 0.95);
  EXPECT_NEAR(verdict.allowed.omega / verdict.allowed.v, 0.4, 1e-9);
}

TEST(CollisionMonitor, AtRestItMayTurnAndBackOutButNotGoOn) {
  const Sweep sweep = sweep_of({pillar(0.35)});
  const Verdict rotation = Bench().run(0.2, sweep, {0.0, 0.8});
  EXPECT_EQ(rotation.allowed, (Twist2{0.0, 0.8}));
  const Verdict on = Bench().run(0.2, sweep, {0.3, 0.8});
  EXPECT_EQ(on.allowed, (Twist2{0.0, 0.8}));
  EXPECT_EQ(on.action, Action::stop);
  const Verdict back = Bench().run(0.2, sweep, {-0.2, 0.0});
  EXPECT_DOUBLE_EQ(back.allowed.v, -0.1);  // 270 degrees: it does not see where it goes, and creeps
  EXPECT_EQ(back.cause, kSight);
}

// Both at once, whatever it does now: motor control brakes along the curve
// (VelocityLimiter.HardBraking...OnTheSameCurve).
TEST(CollisionMonitor, WhatItIsToldToLoseItLosesOfTheTurnAsWell) {
  EXPECT_EQ(Bench().run(0.1, sweep_of({pillar(0.4)}), {0.8, 0.4}, {0.4, 0.2}).allowed, Twist2{});
}

TEST(CollisionMonitor, WhatItsSideWouldOnlyGrazeIsPassedSlowly) {
  // A pillar of 0.5 m beside the path, 0.28 m from its middle: 0.02 m of the robot's 0.3 m would touch
  const Disc beside{{0.2, 0.78}, 0.5};
  const Verdict verdict = Bench().run(0.1, sweep_of({beside}), {0.5, 0.0});
  EXPECT_DOUBLE_EQ(verdict.allowed.v, 0.05);
  EXPECT_EQ(verdict.cause, kStoppingDistance);
  const Disc deeper{{0.2, 0.76}, 0.5};
  EXPECT_EQ(Bench().run(0.1, sweep_of({deeper}), {0.5, 0.0}).allowed.v, 0.0);
}

TEST(CollisionMonitor, AroundLegsItIsSlowEarlier) {
  // A leg whose surface is 0.7 m ahead: 0.2 m before the free distance of 0.4 m ends it is down to 0.2 m/s:
  // v 0.1 + (v^2 - 0.04) / 4 = 0.2 gives v = -0.2 + sqrt(0.04 + 0.04 + 0.8) = 0.738
  const Verdict verdict = Bench().run(0.1, sweep_of({{{0.77, 0.0}, 0.07}}), {1.0, 0.0});
  EXPECT_NEAR(verdict.allowed.v, 0.738, 3e-3);
  EXPECT_EQ(verdict.cause, kNarrowThing);
}

TEST(CollisionMonitor, AccountsForWhereTheRobotWentSinceTheSweep) {
  // 0.08 s after the sweep the robot is 0.04 m nearer: 0.36 - 0.04 - 0.10 m are left
  Bench bench;
  Sweep sweep = sweep_of({pillar(0.66)});
  sweep.time = bench.now;
  bench.monitor.odometry(bench.now, {}, {0.5, 0.0});
  bench.monitor.sweep(bench.now, sweep.view());
  bench.now = bench.now + Duration::milliseconds(80);
  bench.monitor.odometry(bench.now, {0.04, 0.0, 0.0}, {0.5, 0.0});
  EXPECT_NEAR(bench.monitor.judge(bench.now, {1.0, 0.0}).allowed.v, -0.2 + std::sqrt(0.04 + 4.0 * 0.22),
              2e-3);
}

TEST(CollisionMonitor, ACommandThatSlowsDownTooLateIsBrakedHard) {
  // At 1 m/s with 0.42 m free distance a stop at 2 m/s^2, 0.35 m long, is due; the command asks for one, the
  // verdict says how.
  const Verdict verdict = Bench().run(0.1, sweep_of({pillar(0.72)}), {0.0, 0.0}, {1.0, 0.0});
  EXPECT_EQ(verdict.allowed, Twist2{});
  EXPECT_EQ(verdict.action, Action::approach);
  // With 0.3 m it will not stand before it touches: whatever is commanded, this is a stop.
  EXPECT_EQ(Bench().run(0.1, sweep_of({pillar(0.6)}), {0.9, 0.0}, {1.0, 0.0}).action, Action::stop);
  EXPECT_EQ(Bench().run(0.1, sweep_of({}), {0.0, 0.0}, {1.0, 0.0}).action, Action::do_nothing);
}

TEST(CollisionMonitor, StopsWhenTheLaserIsSilentAndResumesAfterAWhile) {
  Bench bench;
  bench.run(0.5, sweep_of({}), {1.0, 0.0}, {1.0, 0.0});
  bench.laser_on = false;
  const Time last = bench.now;
  while (bench.run(0.02, sweep_of({}), {1.0, 0.0}, {1.0, 0.0}).action == Action::do_nothing) {
    ASSERT_LT(bench.now - last, Duration::seconds(1.0));
  }
  EXPECT_LE((bench.now - last).to_seconds(),
            0.26);  // 0.25 s and one cycle, 20 ms of them before the last cycle
  const Verdict stop = bench.run(0.1, sweep_of({}), {1.0, 0.3}, {0.5, 0.0});
  EXPECT_EQ(stop.cause, kLaserSilent);
  EXPECT_EQ(stop.allowed, Twist2{});
  bench.laser_on = true;
  EXPECT_EQ(bench.run(0.36, sweep_of({}), {1.0, 0.0}).action, Action::stop);
  EXPECT_EQ(bench.run(0.3, sweep_of({}), {1.0, 0.0}).action, Action::do_nothing);
}

TEST(CollisionMonitor, WithManualResumeOnlyAResetEndsAStop) {
  CollisionMonitorOptions options;
  options.resume = Resume::manual;
  Bench bench(options);
  EXPECT_EQ(bench.run(0.6, sweep_of({}), {1.0, 0.0}).action, Action::do_nothing);  // the start needs none
  bench.laser_on = false;
  bench.run(0.5, sweep_of({}), {1.0, 0.0});
  bench.laser_on = true;
  EXPECT_EQ(bench.run(2.0, sweep_of({}), {1.0, 0.0}).cause, kWaitingForReset);
  bench.monitor.reset();
  EXPECT_EQ(bench.run(0.1, sweep_of({}), {1.0, 0.0}).action, Action::do_nothing);
}

TEST(CollisionMonitor, StopsForLostSweepsAndForSilentOdometry) {
  for (const float value : {kNan, kInfinity, -kInfinity, 0.0F, -1.0F}) {
    Bench bench;
    bench.run(0.3, sweep_of({}), {1.0, 0.0}, {0.5, 0.0});
    Sweep lost = sweep_of({});
    std::fill(lost.ranges.begin(), lost.ranges.end(), value);
    const Verdict verdict = bench.run(0.36, lost, {1.0, 0.0}, {0.5, 0.0});
    EXPECT_EQ(verdict.action, Action::stop) << value;
    EXPECT_EQ(verdict.cause, kLaserInvalid) << value;
  }
  Bench bench;
  bench.run(0.3, sweep_of({}), {1.0, 0.0});
  for (int i = 0; i < 4; ++i) {
    bench.now = bench.now + Duration::milliseconds(100);
    Sweep sweep = sweep_of({pillar(5.0 + i)});
    sweep.time = bench.now;
    bench.monitor.sweep(bench.now, sweep.view());
  }
  EXPECT_EQ(bench.monitor.judge(bench.now, {1.0, 0.0}).cause, kOdometrySilent);
}

TEST(CollisionMonitor, CreepsWhereSomebodyCouldHideAndStopsWhereNothingIsSeen) {
  const auto blind = [](std::size_t from, std::size_t to) {
    Sweep sweep = sweep_of({});
    for (std::size_t i = from; i < to; ++i) sweep.ranges[i] = kNan;
    return sweep;
  };
  // Beam 359.5 looks ahead; 31 beams are 0.2 rad
  EXPECT_EQ(Bench().run(0.1, blind(350, 370), {1.0, 0.0}).action, Action::do_nothing);
  const Verdict creeps = Bench().run(0.1, blind(340, 380), {1.0, 0.0});
  EXPECT_DOUBLE_EQ(creeps.allowed.v, 0.1);
  EXPECT_EQ(creeps.cause, kSight);
  EXPECT_EQ(Bench().run(0.1, blind(240, 480), {1.0, 0.0}).action, Action::stop);
  EXPECT_EQ(Bench().run(0.1, blind(0, 180), {1.0, 0.0}).action, Action::do_nothing);  // far off the path
}

// A wall all round at 3.3 m, and then the front third is covered: 120 degrees read +inf, as they do of an
// RPLIDAR that measures nothing.
TEST(CollisionMonitor, CreepsIntoWhatWasSeenAndVanished) {
  Bench bench;
  EXPECT_EQ(bench.run(0.5, sweep_of({}, 3.3F), {1.0, 0.0}).allowed.v, 1.0);
  Sweep covered = sweep_of({}, 3.3F);
  std::fill(covered.ranges.begin() + 200, covered.ranges.begin() + 520, kInfinity);
  const Verdict verdict = bench.run(0.5, covered, {1.0, 0.0});
  EXPECT_DOUBLE_EQ(verdict.allowed.v, 0.1);
  EXPECT_EQ(verdict.cause, kSight);
  EXPECT_NEAR(bench.monitor.dark(), 2.0, 0.2);
  EXPECT_EQ(bench.run(3.0, sweep_of({}, 3.3F), {1.0, 0.0}).allowed.v, 1.0);
}

TEST(CollisionMonitor, ZonesLimitByName) {
  CollisionMonitorOptions options;
  options.polygons = {
      {.name = "slow", .radius = 2.0, .action_type = Action::slowdown, .slowdown_ratio = 0.3}};
  Bench bench(options);  // the verdict's cause is the name of its zone
  const Verdict verdict = bench.run(0.1, sweep_of({pillar(1.8)}), {1.0, 0.5});
  EXPECT_NEAR(verdict.allowed.v, 0.3, 1e-9);
  EXPECT_NEAR(verdict.allowed.omega, 0.15, 1e-9);
  EXPECT_EQ(verdict.action, Action::slowdown);
  EXPECT_EQ(verdict.cause, "slow");
  EXPECT_NEAR(Bench(options).run(0.1, sweep_of({pillar(1.8)}), {0.0, 0.5}).allowed.omega, 0.15, 1e-9);
}

TEST(CollisionMonitor, AnythingThatIsNotFiniteIsAStop) {
  Bench bench;
  EXPECT_EQ(bench.run(0.1, sweep_of({}), {std::nan(""), 0.0}).allowed, Twist2{});
  EXPECT_EQ(bench.run(0.1, sweep_of({}), {1.0, std::numeric_limits<double>::infinity()}).allowed, Twist2{});
}

// The first sweep is a fault, and then the laser is silent, as if it had never been: the stop still waits for
// the reset.
TEST(CollisionMonitor, SilenceAfterAFaultIsNoReset) {
  CollisionMonitorOptions options;
  options.resume = Resume::manual;
  Bench bench(options);
  Sweep lost = sweep_of({});
  std::fill(lost.ranges.begin(), lost.ranges.end(), kNan);
  EXPECT_EQ(bench.run(0.1, lost, {1.0, 0.0}).cause, kLaserInvalid);
  bench.now = bench.now + Duration::milliseconds(300);
  EXPECT_EQ(bench.monitor.judge(bench.now, {1.0, 0.0}).cause, kLaserWaiting);
  EXPECT_EQ(bench.run(2.0, sweep_of({}), {1.0, 0.0}).cause, kWaitingForReset);
  bench.monitor.reset();
  EXPECT_EQ(bench.run(0.5, sweep_of({}), {1.0, 0.0}).action, Action::do_nothing);
}

// 200 ms back: sweeps go on, odometry does not, and must not count as fresh until the clock is there again.
TEST(CollisionMonitor, OdometryOfBeforeTheClockWentBackIsNotFresh) {
  Bench bench;
  EXPECT_EQ(bench.run(0.5, sweep_of({}), {1.0, 0.0}).action, Action::do_nothing);
  bench.now = bench.now - Duration::milliseconds(200);
  for (int i = 0; i < 2; ++i) {
    Sweep sweep = sweep_of({pillar(5.0 + i)});
    sweep.time = bench.now = bench.now + Duration::milliseconds(20);
    bench.monitor.sweep(bench.now, sweep.view());
  }
  EXPECT_EQ(bench.monitor.judge(bench.now, {1.0, 0.0}).cause, kOdometrySilent);
}

// 100 ms back: the sweep that comes next has an older stamp than the last one, and shows a wall.
TEST(CollisionMonitor, AfterTheClockWentBackOnlyWhatIsSeenThenCounts) {
  Bench bench;
  EXPECT_EQ(bench.run(0.5, sweep_of({}), {1.0, 0.0}).action, Action::do_nothing);
  bench.now = bench.now - Duration::milliseconds(100);
  EXPECT_EQ(bench.monitor.judge(bench.now, {1.0, 0.0}).cause, kOdometrySilent);
  bench.now = bench.now + Duration::milliseconds(20);
  bench.monitor.odometry(bench.now, {}, {});
  EXPECT_EQ(bench.monitor.judge(bench.now, {1.0, 0.0}).cause, kLaserSilent);
  Sweep wall = sweep_of({pillar(0.35)});
  wall.time = bench.now;
  bench.monitor.sweep(bench.now, wall.view());
  EXPECT_EQ(bench.monitor.laser(bench.now), LaserState::ok);
  EXPECT_EQ(bench.monitor.judge(bench.now, {1.0, 0.0}).allowed, Twist2{});
}

// With a reset between: odometry of before must not become fresh while the clock comes back to where it was.
TEST(CollisionMonitor, AResetAfterTheClockWentBackDoesNotMakeOldOdometryFresh) {
  CollisionMonitorOptions options;
  options.resume = Resume::manual;
  Bench bench(options);
  bench.monitor.odometry(bench.now, {}, {});
  bench.now = bench.now - Duration::milliseconds(100);
  bench.monitor.judge(bench.now, {1.0, 0.0});
  for (int i = 0; i < 2; ++i) {
    Sweep sweep = sweep_of({pillar(5.0 + i)});
    sweep.time = bench.now = bench.now + Duration::milliseconds(50);
    bench.monitor.sweep(bench.now, sweep.view());
  }
  bench.monitor.reset();
  const std::string_view cause = bench.monitor.judge(bench.now, {1.0, 0.0}).cause;
  EXPECT_NE(cause, "");
  EXPECT_NE(cause, kWaitingForReset);
  bench.run(0.1, sweep_of({}), {1.0, 0.0});
  bench.monitor.reset();
  EXPECT_EQ(bench.run(0.6, sweep_of({}), {1.0, 0.0}).action, Action::do_nothing);
}

// A sweep that came before the first odometry was measured nobody knows where.
TEST(CollisionMonitor, ASweepBeforeTheFirstOdometryDoesNotCount) {
  Bench bench;
  Sweep wall = sweep_of({pillar(0.5)});
  wall.time = bench.now;
  bench.monitor.sweep(bench.now, wall.view());
  bench.now = bench.now + Duration::milliseconds(20);
  bench.monitor.odometry(bench.now, {5.0, 3.0, 1.0}, {});
  EXPECT_EQ(bench.monitor.judge(bench.now, {1.0, 0.0}).cause, kLaserWaiting);
}

/// Whatever the sweep and the wish: the answer is finite, no faster than the wish, and on its side.
TEST(CollisionMonitor, NeverMakesACommandFaster) {
  Random random(17);
  for (int i = 0; i < 2000; ++i) {
    std::vector<Disc> discs;
    for (int k = 0; k < 5; ++k)
      discs.push_back({{random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0)}, random.uniform(0.02, 0.4)});
    Sweep sweep = sweep_of(discs, 4.0F);
    for (float& range : sweep.ranges) {
      if (random.uniform() < 0.1) range = kNan;
    }
    const Twist2 wanted{random.uniform(-0.3, 1.2), random.uniform(-1.0, 1.0)};
    const Twist2 out = Bench().run(0.06, sweep, wanted, {random.uniform(-0.2, 1.0), 0.0}).allowed;
    ASSERT_TRUE(is_finite(out));
    EXPECT_LE(std::abs(out.v), std::abs(wanted.v));
    EXPECT_LE(std::abs(out.omega), std::abs(wanted.omega));
    EXPECT_GE(out.v * wanted.v, 0.0);
    EXPECT_GE(out.omega * wanted.omega, 0.0);
  }
}

}  // namespace
}  // namespace bw::safety
