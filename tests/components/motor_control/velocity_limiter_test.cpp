#include "components/motor_control/velocity_limiter.hpp"

#include <cmath>
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr Duration kPeriod = Duration::milliseconds(20);

struct Follower {
  VelocityLimiter limiter;
  Time now = Time::seconds(1.0);

  explicit Follower(const Robot& robot, const LimiterOptions& options = {}) : limiter(robot, options) {
    limiter.step(now);
  }
  LimitedTwist advance(const Twist2& command, Duration period = kPeriod) {
    now = now + period;
    limiter.command(now, command);
    return limiter.step(now);
  }
  LimitedTwist silence(Duration period = kPeriod) {
    now = now + period;
    return limiter.step(now);
  }
};

Robot random_robot(Random& random) {
  Robot robot;
  robot.wheel_separation = random.uniform(0.2, 0.6);
  robot.limits.v_max = random.uniform(0.3, 2.0);
  robot.limits.v_back_max = random.uniform() < 0.2 ? 0.0 : random.uniform(0.05, 0.5);
  robot.limits.omega_max = random.uniform(0.3, 4.0);
  robot.limits.acc_max = random.uniform(0.2, 2.0);
  robot.limits.alpha_max = random.uniform(0.3, 5.0);
  robot.limits.jerk_max = random.uniform(0.5, 20.0);
  robot.limits.stop_deceleration = robot.limits.acc_max + random.uniform(0.0, 2.0);
  robot.wheel_speed_max = random.uniform(0.3, 2.5);
  return robot;
}

double fastest_wheel(const Twist2& t, const Robot& robot) {
  return std::abs(t.v) + std::abs(t.omega) * robot.wheel_separation / 2.0;
}

TEST(Saturate, KeepsTheCurvature) {
  Limits limits;  // v 1.0, back 0.2, omega 1.0
  const Twist2 fast = saturate({2.0, 1.0}, limits, 0.4, 10.0);
  EXPECT_NEAR(fast.v, 1.0, 1e-15);
  EXPECT_NEAR(fast.omega, 0.5, 1e-15);
  const Twist2 limited = saturate({0.5, -4.0}, limits, 0.4, 10.0);
  EXPECT_NEAR(limited.v, 0.125, 1e-15);
  EXPECT_NEAR(limited.omega, -1.0, 1e-15);
  const Twist2 back = saturate({-1.0, 0.5}, limits, 0.4, 10.0);
  EXPECT_NEAR(back.v, -0.2, 1e-15);
  EXPECT_NEAR(back.omega, 0.1, 1e-15);
  // Wheels: 0.5 + 1.0 * 0.2 = 0.7 against 0.35.
  const Twist2 wheels = saturate({0.5, 1.0}, limits, 0.4, 0.35);
  EXPECT_NEAR(wheels.v, 0.25, 1e-15);
  EXPECT_NEAR(wheels.omega, 0.5, 1e-15);
}

TEST(VelocityLimiter, NoLimitIsEverExceededAndTheCommandIsReached) {
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    const Robot robot = random_robot(random);
    const Limits& limits = robot.limits;
    Follower follower(robot);
    Twist2 last{};
    double last_a = 0.0;
    for (int change = 0; change < 25; ++change) {
      const Twist2 command{random.uniform(-1.5, 1.5) * limits.v_max,
                           random.uniform(-1.5, 1.5) * limits.omega_max};
      const bool settle = change % 5 == 4;
      const int steps = settle ? 3000 : static_cast<int>(random.uniform(1.0, 60.0));
      for (int i = 0; i < steps; ++i) {
        // The period wanders as on a real clock.
        const Duration period = Duration::milliseconds(static_cast<std::int64_t>(random.uniform(15.0, 26.0)));
        const double dt = period.to_seconds();
        const Twist2 now = follower.advance(command, period).twist;
        const double a = (now.v - last.v) / dt;
        ASSERT_LE(now.v, limits.v_max + 1e-9) << "seed " << seed;
        ASSERT_GE(now.v, -limits.v_back_max - 1e-9) << "seed " << seed;
        ASSERT_LE(std::abs(now.omega), limits.omega_max + 1e-9) << "seed " << seed;
        ASSERT_LE(fastest_wheel(now, robot), robot.wheel_speed_max + 1e-9) << "seed " << seed;
        ASSERT_LE(std::abs(a), limits.acc_max + 1e-9) << "seed " << seed;
        ASSERT_LE(std::abs(now.omega - last.omega), limits.alpha_max * dt + 1e-9) << "seed " << seed;
        ASSERT_LE(std::abs(a - last_a), limits.jerk_max * dt + 1e-9) << "seed " << seed;
        last = now;
        last_a = a;
      }
      if (settle) {
        const Twist2 expected = saturate(command, limits, robot.wheel_separation, robot.wheel_speed_max);
        ASSERT_NEAR(last.v, expected.v, 1e-9) << "seed " << seed;
        ASSERT_NEAR(last.omega, expected.omega, 1e-9) << "seed " << seed;
      }
    }
  }
}

TEST(VelocityLimiter, ARampFromRestTakesTheTimeOfTheJerkLimitedProfileAndNeverOvershoots) {
  // v / a + a / j = 1 / 1 + 1 / 5 = 1.2 s in continuous time; sampled at 20 ms it may take a few steps more.
  Follower follower{Robot{}};
  double reached = -1.0;
  for (int i = 1; i <= 100; ++i) {
    const double v = follower.advance({1.0, 0.0}).twist.v;
    ASSERT_LE(v, 1.0 + 1e-12);
    if (reached < 0.0 && v > 0.999) reached = i * 0.02;
  }
  EXPECT_GT(reached, 1.1);
  EXPECT_LT(reached, 1.3);
}

TEST(VelocityLimiter, CommandsOlderThan200MsStopAtTheStopDeceleration) {
  Follower follower{Robot{}};  // stop_deceleration 2, acc_max 1
  for (int i = 0; i < 100; ++i) follower.advance({1.0, 0.0});
  for (int i = 1; i <= 10; ++i) {
    const LimitedTwist kept = follower.silence();
    EXPECT_EQ(kept.state, LimiterState::following) << i * 20 << " ms";
    EXPECT_NEAR(kept.twist.v, 1.0, 1e-9);
  }
  // From the first step past 200 ms: 0.04 m/s less each 20 ms, at rest after 25 steps, no jerk limit.
  for (int i = 1; i <= 25; ++i) {
    const LimitedTwist braking = follower.silence();
    EXPECT_EQ(braking.state, LimiterState::stale);
    EXPECT_NEAR(braking.twist.v, 1.0 - 0.04 * i, 1e-9);
  }
  EXPECT_EQ(follower.silence().twist, Twist2{});
}

// 60 s back, as a simulation that begins again: nobody knows how old the command is, so that it counts no
// more, and one whose source fell silent long ago does not count anew. The next one does.
TEST(VelocityLimiter, AClockThatGoesBackForgetsTheCommand) {
  Follower follower{Robot{}};
  follower.now = Time::seconds(61.0);
  for (int i = 0; i < 100; ++i) follower.advance({1.0, 0.0});
  for (int i = 0; i < 100; ++i) follower.silence();
  follower.now = Time::seconds(1.0);
  for (int i = 0; i < 4000; ++i) ASSERT_EQ(follower.silence().twist, Twist2{}) << i * 20 << " ms";
  EXPECT_EQ(follower.advance({1.0, 0.0}).state, LimiterState::following);
}

// The clock goes back while it is told to stop, and comes to where the command was heard.
TEST(VelocityLimiter, AClockThatGoesBackDuringAStopForgetsTheCommand) {
  Follower follower{Robot{}};
  follower.advance({1.0, 0.0});
  follower.now = follower.now - Duration::milliseconds(100);
  follower.limiter.stop(follower.now);
  EXPECT_EQ(follower.silence(Duration::milliseconds(100)).state, LimiterState::waiting);
}

// Its process hangs for 2 s at full speed, and the base has come to rest meanwhile: it does not brake from
// there on once more.
TEST(VelocityLimiter, HasBrakedWhenAStallIsOver) {
  Follower follower{Robot{}};
  for (int i = 0; i < 200; ++i) follower.advance({1.0, 0.0});
  Follower silent = follower;
  EXPECT_EQ(silent.silence(Duration::milliseconds(2000)).twist, Twist2{});
  EXPECT_EQ(follower.advance({}, Duration::milliseconds(2000)).twist, Twist2{});
}

TEST(VelocityLimiter, BeginsAtRestAndWithoutACommandAfterRest) {
  Follower follower{Robot{}};
  for (int i = 0; i < 100; ++i) follower.advance({1.0, 0.0});
  follower.limiter.rest();
  const LimitedTwist limited = follower.silence();
  EXPECT_EQ(limited.state, LimiterState::waiting);
  EXPECT_EQ(limited.twist, Twist2{});
}

TEST(VelocityLimiter, FreshCommandsResumeAfterAStopAndBothWheelsBrakeInProportion) {
  Follower follower{Robot{}};
  for (int i = 0; i < 200; ++i) follower.advance({0.8, 0.4});
  for (int i = 0; i < 15; ++i) follower.silence();
  const Twist2 braking = follower.silence().twist;
  EXPECT_GT(braking.v, 0.1);
  EXPECT_NEAR(braking.omega / braking.v, 0.5, 1e-9);
  LimitedTwist resumed{};
  for (int i = 0; i < 300; ++i) resumed = follower.advance({0.8, 0.4});
  EXPECT_EQ(resumed.state, LimiterState::following);
  EXPECT_NEAR(resumed.twist.v, 0.8, 1e-9);
}

TEST(VelocityLimiter, UnusableCommandsStopTheRobotAndSaySo) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const std::pair<Twist2, LimiterState> cases[] = {
      {{kNan, 0.0}, LimiterState::not_finite},      {{0.5, kNan}, LimiterState::not_finite},
      {{kInfinity, 0.0}, LimiterState::not_finite}, {{0.5, -kInfinity}, LimiterState::not_finite},
      {{10.1, 0.0}, LimiterState::implausible},     {{0.5, -10.1}, LimiterState::implausible},
      {{1e308, 1e308}, LimiterState::implausible},  {{9.9, 9.9}, LimiterState::following},
      {{-9.9, 0.0}, LimiterState::following},
  };
  for (const auto& [command, state] : cases) {
    Follower follower{Robot{}};
    for (int i = 0; i < 100; ++i) follower.advance({0.6, 0.1});
    const LimitedTwist first = follower.advance(command);
    EXPECT_EQ(first.state, state) << command.v << ' ' << command.omega;
    EXPECT_TRUE(is_finite(first.twist));
    EXPECT_FALSE(describe(first.state).empty());
    if (state == LimiterState::following) continue;
    EXPECT_LT(first.twist.v, 0.6 - 0.03);
    for (int i = 0; i < 30; ++i) follower.advance(command);
    EXPECT_EQ(follower.advance(command).twist, Twist2{});
    EXPECT_EQ(follower.advance({0.1, 0.0}).state, LimiterState::following);
  }
}

TEST(VelocityLimiter, StopOverridesAFreshCommand) {
  Follower follower{Robot{}};
  for (int i = 0; i < 100; ++i) follower.advance({1.0, 0.0});
  for (int i = 1; i <= 25; ++i) {
    follower.now = follower.now + kPeriod;
    follower.limiter.command(follower.now, {1.0, 0.0});
    const LimitedTwist braking = follower.limiter.stop(follower.now);
    EXPECT_EQ(braking.state, LimiterState::told_to);
    EXPECT_NEAR(braking.twist.v, 1.0 - 0.04 * i, 1e-9);
  }
}

TEST(VelocityLimiter, HardBrakingReachesALowerSpeedAtTheStopDecelerationOnTheSameCurve) {
  for (const double alpha_max : {1.5, 6.0}) {  // however soon it could stop rotating
    Robot robot;
    robot.limits = {
        .v_max = 1.0, .omega_max = 1.0, .acc_max = 1.0, .alpha_max = alpha_max, .stop_deceleration = 2.0};
    Follower follower(robot);
    for (int i = 0; i < 200; ++i) follower.advance({1.0, 0.9});
    follower.limiter.set_braking(Braking::hard);
    double v = 1.0;
    // The faster wheel, 1 + 0.9 * 0.195 = 1.1755 times as fast, loses 2 m/s^2: after 17 steps of 20 ms 0.42
    // m/s, curvature 0.9 / m all the way
    for (int i = 0; i < 17; ++i) {
      v -= 0.04 / 1.1755;
      const Twist2 twist = follower.advance({0.4, 0.36}).twist;
      EXPECT_NEAR(twist.v, v, 1e-9);
      EXPECT_NEAR(twist.omega, 0.9 * v, 1e-6);
    }
    EXPECT_NEAR(follower.advance({0.4, 0.36}).twist.v, 0.4, 1e-9);
    for (int i = 0; i < 12; ++i) follower.advance({0.0, 0.0});
    EXPECT_EQ(follower.advance({0.0, 0.0}).twist, Twist2{});
    // Speeding up stays smooth: 5 m/s^3 for 20 ms is 0.1 m/s^2, 0.002 m/s in this step.
    EXPECT_NEAR(follower.advance({1.0, 0.0}).twist.v, 0.002, 1e-9);
  }
}

// On the spot a wheel, 0.195 m off the middle, loses 2 m/s^2: 10.26 rad/s^2, which is what the collision
// monitor reckons with; alpha_max is for rotations that nothing limits.
TEST(VelocityLimiter, HardBrakingOfATurnIsThatOfTheWheels) {
  Robot robot;
  robot.limits = {.v_max = 1.0, .omega_max = 1.0, .acc_max = 1.0, .alpha_max = 1.5, .stop_deceleration = 2.0};
  for (const double to : {0.0, -1.0}) {
    Follower follower(robot);
    for (int i = 0; i < 200; ++i) follower.advance({0.0, 1.0});
    EXPECT_NEAR(follower.advance({0.0, 0.5}).twist.omega, 1.0 - 0.03, 1e-9);
    follower.limiter.set_braking(Braking::hard);
    EXPECT_NEAR(follower.advance({0.0, to}).twist.omega, 0.97 - 0.04 / 0.195, 1e-9);
  }
}

// Steering is none: 1.5 rad/s^2 for 20 ms are 0.03 rad/s. The monitor reckons with that on the way of a stop
// (stop_path.hpp).
TEST(VelocityLimiter, AnotherTurnAtTheSameSpeedIsNoBraking) {
  Robot robot;
  robot.limits = {.v_max = 1.0, .omega_max = 1.0, .acc_max = 1.0, .alpha_max = 1.5, .stop_deceleration = 2.0};
  Follower follower(robot);
  for (int i = 0; i < 300; ++i) follower.advance({0.5, 0.5});
  follower.limiter.set_braking(Braking::hard);
  const Twist2 twist = follower.advance({0.5, -0.5}).twist;
  EXPECT_NEAR(twist.v, 0.5, 1e-9);
  EXPECT_NEAR(twist.omega, 0.5 - 0.03, 1e-9);
}

TEST(VelocityLimiter, HardBrakingOfABackwardCommandPassesThroughRest) {
  Robot robot;
  robot.limits.stop_deceleration = 2.0;
  Follower follower(robot);
  for (int i = 0; i < 200; ++i) follower.advance({0.5, 0.0});
  follower.limiter.set_braking(Braking::hard);
  double v = 0.5;
  while (v > 0.0) {
    const double next = follower.advance({-0.2, 0.0}).twist.v;
    EXPECT_NEAR(next, std::max(0.0, v - 0.04), 1e-9);
    v = next;
  }
  for (int i = 0; i < 100; ++i) v = follower.advance({-0.2, 0.0}).twist.v;
  EXPECT_NEAR(v, -0.2, 1e-6);
}

TEST(VelocityLimiter, StandsBeforeTheFirstCommand) {
  Follower follower{Robot{}};
  const LimitedTwist standing = follower.silence();
  EXPECT_EQ(standing.state, LimiterState::waiting);
  EXPECT_EQ(standing.twist, Twist2{});
}

TEST(VelocityLimiter, ForbiddenBackwardDrivingIsAStop) {
  Robot robot;
  robot.limits.v_back_max = 0.0;
  Follower follower(robot);
  for (int i = 0; i < 100; ++i) follower.advance({-0.5, 0.3});
  EXPECT_EQ(follower.advance({-0.5, 0.3}).twist, Twist2{});
}

}  // namespace
}  // namespace bw
