// Every sequence of commands, silence, stops and clock steps through the velocity limiter, step by step of 20
// ms: how far a speed may change in a step, and when the robot must come to rest.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

#include "components/motor_control/velocity_limiter.hpp"
#include "tests/exhaustive_sequences.hpp"

namespace bw {
namespace {

constexpr Duration kStep = Duration::milliseconds(20);
constexpr double kTolerance = 1e-9;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

struct LimiterWorld {
  void command(const Twist2& twist) {
    limiter.command(now, twist);
    wish = twist;
    heard = now;
  }
  void step_back(Duration by) {
    now = now - by;
    if (heard && *heard > now) heard.reset();  // how old it is nobody knows
    step(Duration{});
  }
  void stall() {
    now = now + Duration::milliseconds(1000);
    step(Duration::milliseconds(1000));
  }
  void steps(int count) {
    for (int i = 0; i < count; ++i) {
      now = now + kStep;
      step(kStep);
    }
  }

  void step(Duration elapsed) {
    const LimitedTwist limited = is_stopped ? limiter.stop(now) : limiter.step(now);
    judge(given, limited, elapsed.to_seconds());
    faster = limited.twist.v - given.v;
    given = limited.twist;
    state = limited.state;
  }

  double fastest(const Twist2& twist) const {
    return std::abs(twist.v) + std::abs(twist.omega) * robot.wheel_separation / 2.0;
  }

  void judge(const Twist2& before, const LimitedTwist& limited, double dt) {
    const Limits& limits = robot.limits;
    const Twist2& after = limited.twist;
    const double slower = fastest(before) - fastest(after);
    if (!is_finite(after)) violation = "what is no number goes out";
    if (fastest(after) > robot.wheel_speed_max + kTolerance) violation = "a wheel is too fast";
    if (after.v > limits.v_max + kTolerance || after.v < -limits.v_back_max - kTolerance)
      violation = "too fast";
    if (std::abs(after.omega) > limits.omega_max + kTolerance) violation = "turns too fast";
    if (describe(limited.state).empty()) violation = "no reason is said";
    const bool is_fresh = heard && now - *heard <= Duration::seconds(options.command_timeout);
    const bool is_sound = is_finite(wish) && std::abs(wish.v) < 100.0;
    const bool follows = limited.state == LimiterState::following;
    if (follows != (is_fresh && is_sound && !is_stopped))
      violation = "follows what it must not, or not what it must";
    const double most = std::max(limits.acc_max, limits.stop_deceleration) * dt;
    if (std::abs(after.v - before.v) > most + kTolerance) violation = "the speed jumps";
    if (!follows && slower < std::min(fastest(before), limits.stop_deceleration * dt) - kTolerance)
      violation = "does not brake though it may not drive";
    if (!follows && after.v * before.v < -kTolerance) violation = "turns back while it brakes";
  }

  Robot robot;
  LimiterOptions options;
  VelocityLimiter limiter{robot, options};
  Time now = Time::seconds(100.0);
  std::optional<Time> heard;  ///< the newest command, on a clock that has not gone back since
  Twist2 wish;
  bool is_stopped = false, is_hard = false, is_slow = false;
  Twist2 given;
  double faster = 0.0;  ///< by the last step [m/s]
  LimiterState state = LimiterState::waiting;
  std::string violation;
};

std::string state_of(const LimiterWorld& w) {
  const Duration age = w.heard ? std::min(w.now - *w.heard, Duration::milliseconds(300)) : Duration{-1};
  char text[160];
  std::snprintf(text, sizeof text, "%.9f %.9f %.9f %d %.1f %.1f %d%d%d %lld", w.given.v, w.given.omega,
                w.faster, static_cast<int>(w.state), w.wish.v, w.wish.omega, w.is_stopped, w.is_hard,
                w.is_slow, static_cast<long long>(age.nanoseconds / 1'000'000));
  return text;
}

TEST(VelocityLimiter, FollowsOnlyWhatIsFreshAndSoundInEverySequence) {
  const auto says = [](const Twist2& twist) { return [=](LimiterWorld& w) { w.command(twist); }; };
  const auto steps = [](int count) { return [=](LimiterWorld& w) { w.steps(count); }; };
  const auto back = [](int ms) { return [=](LimiterWorld& w) { w.step_back(Duration::milliseconds(ms)); }; };
  const auto brakes = [](Braking how) {
    return [=](LimiterWorld& w) {
      w.limiter.set_braking(how);
      w.is_hard = how == Braking::hard;
    };
  };
  const auto allows = [](double v_max) {
    return [=](LimiterWorld& w) {
      Limits limits = w.robot.limits;
      limits.v_max = v_max;
      w.limiter.allow(limits);
      w.is_slow = v_max < w.robot.limits.v_max;
    };
  };
  const test::Sequences<LimiterWorld> sequences{
      .make = [] { return LimiterWorld{}; },
      .events = {{"forward", says({0.8, 0.3})},
                 {"backward", says({-0.3, 0.0})},
                 {"turn", says({0.0, 2.0})},
                 {"stand", says({})},
                 {"NaN", says({0.5, kNan})},
                 {"implausible", says({1e3, 0.0})},
                 {"told to stop", [](LimiterWorld& w) { w.is_stopped = true; }},
                 {"no longer told to stop", [](LimiterWorld& w) { w.is_stopped = false; }},
                 {"hard braking", brakes(Braking::hard)},
                 {"smooth braking", brakes(Braking::smooth)},
                 {"speed limit 0.2 m/s", allows(0.2)},
                 {"speed limit 1 m/s", allows(1.0)},
                 {"20 ms", steps(1)},
                 {"300 ms", steps(15)},
                 {"a step 1 s late", [](LimiterWorld& w) { w.stall(); }},
                 {"clock back 100 ms", back(100)},
                 {"clock back 5 s", back(5000)}},
      .broken = [](const LimiterWorld& world) { return world.violation; },
      .state = state_of};
  test::expect_unbroken("velocity_limiter", sequences, test::sequence_depth(11));
}

}  // namespace
}  // namespace bw
