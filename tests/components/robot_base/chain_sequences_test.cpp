// Who drives, multiplexer, collision monitor, velocity limiter and the guard of the base as values one behind
// the other, through every sequence of what happens to them: 250 ms of the chain follow each event. The robot
// stands when nobody asks it to drive, when one of the chain is dead, before a wall, and after a stop until
// the release, and there is a reason for it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "components/motor_control/velocity_limiter.hpp"
#include "components/robot_base/base_guard.hpp"
#include "components/safety/collision_monitor.hpp"
#include "components/twist_mux/twist_mux.hpp"
#include "tests/exhaustive_sequences.hpp"

namespace bw {
namespace {

constexpr Duration kTick = Duration::milliseconds(10);
constexpr double kMoves = 1e-6;  // [m/s]
constexpr std::size_t kHand = 0, kPlanner = 1;

TwistMuxOptions two_sources() {
  return {.sources = {{.topic = "hand", .priority = 100, .timeout = 0.2},
                      {.topic = "planner", .priority = 10, .timeout = 0.5}}};
}

class Chain {
 public:
  bool hand_speaks = false, planner_speaks = false;
  bool mux_is_dead = false, monitor_is_dead = false, limiter_is_dead = false;
  bool laser_is_dead = false, has_wall = false;
  bool is_pressed = false;
  std::string violation;

  Readings& readings() { return readings_; }
  void set_emergency_stop(bool is_on) {
    is_pressed = is_on;
    is_stopped_ = is_stopped_ || is_on;
    guard_.set_emergency_stop(is_on);
  }
  void release() {
    if (guard_.release()) return;
    if (is_pressed) violation = "released while the emergency stop is pressed";
    is_stopped_ = false;
  }
  /// A limiter that hangs meanwhile cannot know for how long: it brakes from where it was once more.
  void step_back(double seconds) {
    now_ = now_ - Duration::seconds(seconds);
    if (limiter_is_dead) idle_ = 0;
  }

  void pass(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) {
      now_ = now_ + kTick;
      ++ticks_;
      speak();
      if (ticks_ % 2 == 0 && !monitor_is_dead) watch();
      if (ticks_ % 2 == 0 && !limiter_is_dead) limit();
      obey();
      judge();
    }
  }

  std::string state() const {
    std::string text = std::to_string(ticks_ % 10) + ' ' + std::to_string(output_.wheels.left) + ' ' +
                       std::to_string(limited_.twist.v) + ' ' +
                       std::to_string(static_cast<int>(output_.condition)) + ' ' +
                       std::to_string(static_cast<int>(output_.commands)) + ' ' +
                       std::to_string(static_cast<int>(limited_.state)) + ' ' + output_.reason + ' ' +
                       std::string(cause_) + ' ' + std::to_string(std::min(idle_, 100)) + ' ';
    const bool flags[] = {hand_speaks,   planner_speaks, mux_is_dead, monitor_is_dead,    limiter_is_dead,
                          laser_is_dead, has_wall,       is_pressed,  output_.is_latched, is_stopped_};
    for (const bool flag : flags) text += flag ? '1' : '0';
    return text + (readings_.link.is_open ? "o" : "c") + (readings_.contacts->any_bumper() ? "b" : "-");
  }

 private:
  void speak() {
    const auto say = [this](std::size_t who, const Twist2& twist) {
      pass_on(mux_.command(now_, who, twist));
    };
    if (mux_is_dead) return;
    if (hand_speaks && ticks_ % 5 == 0) say(kHand, {0.4, 0.0});
    if (planner_speaks && ticks_ % 10 == 0) say(kPlanner, {0.5, 0.0});
    pass_on(mux_.check(now_));
  }
  void pass_on(const std::optional<Twist2>& twist) {
    if (!twist) return;
    wanted_ = *twist;
    wanted_at_ = now_;
  }
  /// As the component does.
  void watch() {
    monitor_.odometry(now_, {x_, 0.0, 0.0}, {output_.wheels.left, 0.0});
    if (!laser_is_dead && ticks_ % 10 == 0) sweep();
    if (wanted_at_ && *wanted_at_ > now_) {
      wanted_ = {};
      wanted_at_ = now_;
    }
    const bool is_silent = !wanted_at_ || now_ - *wanted_at_ > Duration::milliseconds(200);
    const safety::Verdict verdict = monitor_.judge(now_, is_silent ? Twist2{} : wanted_);
    cause_ = is_silent ? "command_silent" : verdict.cause;
    if (limiter_is_dead) return;
    const bool acts = verdict.action != safety::Action::do_nothing;
    limiter_.set_braking(acts ? Braking::hard : Braking::smooth);
    limiter_.command(now_, is_silent ? Twist2{} : verdict.allowed);
  }
  void sweep() {
    std::vector<float> ranges(73, has_wall ? 0.35F : 5.0F);
    ranges[static_cast<std::size_t>(ticks_ / 10) % ranges.size()] += 0.01F;
    monitor_.sweep(now_, {.time = now_,
                          .angle_min = -std::numbers::pi,
                          .angle_increment = 2.0 * std::numbers::pi / 73.0,
                          .range_min = 0.05,
                          .range_max = 20.0,
                          .ranges = ranges});
  }
  void limit() {
    limited_ = limiter_.step(now_);
    guard_.command(now_, to_wheel_speeds(limited_.twist, robot_.wheel_separation));
  }
  void obey() {
    Readings poll = readings_;
    if (poll.link.is_open) poll.counts.push_back({.time = now_});
    guard_.read(now_, poll);
    const double distance = (output_.wheels.left + output_.wheels.right) / 2.0 * kTick.to_seconds();
    x_ += distance;
    if (poll.link.is_open)
      guard_.moved(now_, {output_.wheels.left * kTick.to_seconds(), output_.wheels.right * kTick.to_seconds(),
                          kTick.to_seconds()});
    before_ = output_;
    output_ = guard_.step(now_);
    guard_.told(now_, output_.wheels, readings_.link.is_open);
  }

  static double fastest(const WheelSpeeds& w) { return std::max(std::abs(w.left), std::abs(w.right)); }

  void judge() {
    const double speed = fastest(output_.wheels), before = fastest(before_.wheels);
    const bool backs_off = output_.condition == BaseCondition::backing_off;
    if (readings_.contacts->any_bumper()) is_stopped_ = true;
    is_stopped_ = is_stopped_ || output_.is_latched;
    if (!std::isfinite(speed)) violation = "what is no number goes to the wheels";
    if (is_stopped_ && !backs_off && speed > before + kMoves)
      violation = "drives faster after a stop that nobody released";
    if (is_pressed && backs_off) violation = "backs off though the emergency stop is pressed";
    // Time-outs of the planner, of the limiter and of the base, and the ramps behind one another.
    const bool may = hand_speaks || planner_speaks;
    const bool is_whole = !mux_is_dead && !monitor_is_dead && !limiter_is_dead && !laser_is_dead && !has_wall;
    idle_ = may && is_whole && !is_stopped_ ? 0 : idle_ + 1;
    if (idle_ > 150 && speed > kMoves && !backs_off) violation = "drives though nobody may";
    const bool says_why = !output_.reason.empty() || output_.commands != WatchdogState::obeying ||
                          limited_.state != LimiterState::following || !cause_.empty();
    unsaid_ = speed > kMoves || says_why || !may ? 0 : unsaid_ + 1;
    if (unsaid_ > 20) violation = "stands without a reason";
  }

  Robot robot_;
  TwistMux mux_{two_sources()};
  safety::CollisionMonitor monitor_{robot_, {}};
  VelocityLimiter limiter_{robot_, {}};
  BaseGuard guard_{{}, robot_, 0.1};
  Readings readings_{.contacts = ContactReading{}, .link = {.is_open = true}};
  Time now_ = Time::seconds(100.0);
  std::int64_t ticks_ = 0;
  double x_ = 0.0;
  Twist2 wanted_;
  std::optional<Time> wanted_at_;
  std::string_view cause_;
  LimitedTwist limited_;
  BaseOutput output_, before_;
  bool is_stopped_ = false;    ///< something stopped it that takes a release
  int idle_ = 0, unsaid_ = 0;  ///< [10 ms]
};

TEST(Chain, DrivesOnlyWhenAllOfItAgreesInEverySequence) {
  const auto then = [](auto change) {
    return [=](Chain& chain) {
      change(chain);
      chain.pass(0.25);
    };
  };
  const test::Sequences<Chain> sequences{
      .make =
          [] {
            Chain chain;
            chain.planner_speaks = true;
            chain.pass(2.0);
            return chain;
          },
      .events = {{"the planner speaks or not", then([](Chain& c) { c.planner_speaks = !c.planner_speaks; })},
                 {"the hand speaks or not", then([](Chain& c) { c.hand_speaks = !c.hand_speaks; })},
                 {"the mux dies or lives", then([](Chain& c) { c.mux_is_dead = !c.mux_is_dead; })},
                 {"the monitor dies or lives",
                  then([](Chain& c) { c.monitor_is_dead = !c.monitor_is_dead; })},
                 {"the limiter dies or lives",
                  then([](Chain& c) { c.limiter_is_dead = !c.limiter_is_dead; })},
                 {"the laser dies or lives", then([](Chain& c) { c.laser_is_dead = !c.laser_is_dead; })},
                 {"a wall or none", then([](Chain& c) { c.has_wall = !c.has_wall; })},
                 {"emergency stop", then([](Chain& c) { c.set_emergency_stop(!c.is_pressed); })},
                 {"bumper", then([](Chain& c) {
                    bool& bumper = c.readings().contacts->bumper_centre;
                    bumper = !bumper;
                  })},
                 {"cable", then([](Chain& c) { c.readings().link.is_open = !c.readings().link.is_open; })},
                 {"release", then([](Chain& c) { c.release(); })},
                 {"clock back 5 s", then([](Chain& c) { c.step_back(5.0); })},
                 {"clock back 100 ms", then([](Chain& c) { c.step_back(0.1); })},
                 {"2 s", [](Chain& c) { c.pass(2.0); }}},
      .broken = [](const Chain& chain) { return chain.violation; },
      .state = [](const Chain& chain) { return chain.state(); }};
  test::expect_unbroken("mux, monitor, limiter, guard", sequences, test::sequence_depth(5));
}

}  // namespace
}  // namespace bw
