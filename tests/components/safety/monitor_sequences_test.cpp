// Every sequence of sweeps (sound, repeated, unsound, empty, with a wall), odometry, silence, resets, changed
// options and clock steps through the collision monitor, judged every 50 ms: nothing passes without a sound
// sweep and odometry of the last 250 ms, nor before the reset when `resume` is manual, nor into a wall; and
// once all is well again it drives.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "components/safety/collision_monitor.hpp"
#include "tests/exhaustive_sequences.hpp"

namespace bw::safety {
namespace {

constexpr Duration kCycle = Duration::milliseconds(50);
constexpr float kNoRange = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity();
const Twist2 kAhead{0.5, 0.0};

/// 73 beams all round.
struct MonitorWorld {
  explicit MonitorWorld(Resume resume) : options(options_of(resume)) {}

  static CollisionMonitorOptions options_of(Resume resume) {
    CollisionMonitorOptions options;
    options.resume = resume;
    return options;
  }

  void see(float range, bool is_sound) {
    std::vector<float> ranges(73, range);
    if (std::isfinite(range)) ranges[count++ % ranges.size()] += 0.01F;  // no two sweeps are the same
    sweep(ranges);
    if (is_sound && sound_at == now) has_wall = range < 1.0F;
    judge();
  }
  void repeat() {
    sweep(newest);
    judge();
  }
  /// 50 ms after what was before.
  void sweep(const std::vector<float>& ranges) {
    pass(1, false);
    newest = ranges;
    monitor.sweep(now, {.time = now,
                        .angle_min = -std::numbers::pi,
                        .angle_increment = 2.0 * std::numbers::pi / 73.0,
                        .range_min = 0.05,
                        .range_max = 20.0,
                        .ranges = ranges});
    if (monitor.sweep_fault() == SweepFault::none) sound_at = now;
  }
  void odometry(double v) {
    monitor.odometry(now, {x, 0.0, 0.0}, {v, 0.0});
    speed = v;
    odometry_at = now;
    has_odometry = true;
    judge();
  }
  void reset() {
    monitor.reset();
    is_latched = false;
    judge();
  }
  void step_back(double seconds) {
    now = now - Duration::seconds(seconds);
    for (auto* time : {&sound_at, &odometry_at}) time->reset();
    judge();
  }
  void pass(int cycles, bool is_well) {
    for (int i = 0; i < cycles; ++i) {
      now = now + kCycle;
      x += speed * kCycle.to_seconds();
      if (is_well) odometry(speed);
      judge();
      if (is_well) see(5.0F, true);
    }
  }

  bool is_fresh(const std::optional<Time>& time) const {
    return time && now - *time <= Duration::seconds(options.source_timeout);
  }

  void judge() {
    const Verdict verdict = monitor.judge(now, kAhead);
    const bool moves = verdict.allowed != Twist2{};
    if (!is_finite(verdict.allowed) || verdict.allowed.v < 0.0 || verdict.allowed.v > kAhead.v)
      violation = "more than was wanted";
    if (moves && !is_fresh(sound_at)) violation = "drives without a sound sweep";
    if (moves && !is_fresh(odometry_at)) violation = "drives without odometry";
    if (moves && is_latched) violation = "drives again after a fault without a reset";
    if (moves && has_wall) violation = "drives into a wall";
    if (verdict.allowed != kAhead && verdict.cause.empty()) violation = "limits without a cause";
    if (!moves && verdict.action != Action::stop) violation = "stands, and does not say stop";
    const LaserState laser = monitor.laser(now);
    const bool is_beginning = laser == LaserState::waiting || !has_odometry;
    const bool is_well = laser == LaserState::ok && is_fresh(odometry_at);
    if (!is_well && !is_beginning && options.resume == Resume::manual) is_latched = true;
    cause = verdict.cause;
    allowed = verdict.allowed.v;
  }

  /// All is well for 2 s, and a reset amid of them: a robot that stands for no reason any more drives.
  bool recovers() const {
    MonitorWorld later = *this;
    later.pass(5, true);
    later.reset();
    later.pass(15, true);
    return later.violation.empty() && later.allowed > 0.0;
  }

  std::string state() const {
    std::string text;
    for (const auto& time : {sound_at, odometry_at})
      text +=
          time ? std::to_string(std::min(now - *time, Duration::milliseconds(700)).nanoseconds / 50'000'000) +
                     ' '
               : "- ";
    for (const bool flag : {is_latched, has_wall, has_odometry, has_zone}) text += flag ? '1' : '0';
    const float first = newest.empty() ? 0.0F : newest.back();
    return text + ' ' + cause + ' ' + std::to_string(allowed) + ' ' + std::to_string(speed) + ' ' +
           std::to_string(first) + ' ' + std::to_string(static_cast<int>(monitor.laser(now)));
  }

  CollisionMonitorOptions options;
  CollisionMonitor monitor{Robot{}, options};
  Time now = Time::seconds(100.0);
  double x = 0.0, speed = 0.0;
  std::size_t count = 0;
  std::vector<float> newest = std::vector<float>(73, 5.0F);
  std::optional<Time> sound_at, odometry_at;  ///< on a clock that has not gone back since
  bool is_latched = false, has_wall = false, has_odometry = false, has_zone = false;
  std::string cause;
  double allowed = 0.0;
  std::string violation;
};

void expect_sound(const char* name, Resume resume) {
  using World = MonitorWorld;
  const auto sees = [](float range, bool is_sound) { return [=](World& w) { w.see(range, is_sound); }; };
  const auto odometry = [](double v) { return [=](World& w) { w.odometry(v); }; };
  const auto passes = [](int cycles, bool is_well) { return [=](World& w) { w.pass(cycles, is_well); }; };
  const auto back = [](double seconds) { return [=](World& w) { w.step_back(seconds); }; };
  const auto zone = [](bool has_zone) {
    return [=](World& w) {
      w.has_zone = has_zone;
      w.options.polygons.clear();
      if (has_zone)
        w.options.polygons = {
            {.name = "slow", .radius = 6.0, .action_type = Action::slowdown, .slowdown_ratio = 0.3}};
      w.monitor.set_options(w.options);
      w.judge();
    };
  };
  const test::Sequences<World> sequences{
      .make = [resume] { return World(resume); },
      .events = {{"a sound sweep", sees(5.0F, true)},
                 {"a wall at 0.35 m", sees(0.35F, true)},
                 {"the same sweep again", [](World& w) { w.repeat(); }},
                 {"a sweep of NaN", sees(kNoRange, false)},
                 {"a sweep of +inf", sees(kInfinity, false)},
                 {"odometry, at rest", odometry(0.0)},
                 {"odometry, 0.5 m/s", odometry(0.5)},
                 {"50 ms of silence", passes(1, false)},
                 {"300 ms of silence", passes(6, false)},
                 {"600 ms, all is well", passes(6, true)},
                 {"reset", [](World& w) { w.reset(); }},
                 {"a zone more", zone(true)},
                 {"no zone", zone(false)},
                 {"clock back 100 ms", back(0.1)},
                 {"clock back 5 s", back(5.0)}},
      .broken =
          [](const World& world) {
            if (!world.violation.empty()) return world.violation;
            return world.recovers() ? std::string() : std::string("does not drive though all is well again");
          },
      .state = [](const World& world) { return world.state(); }};
  test::expect_unbroken(name, sequences, test::sequence_depth(4));
}

TEST(CollisionMonitor, DrivesOnlyOnWhatIsFreshAndSoundInEverySequence) {
  expect_sound("collision_monitor, automatic", Resume::automatic);
}
TEST(CollisionMonitor, WaitsForTheResetInEverySequence) {
  expect_sound("collision_monitor, manual", Resume::manual);
}

}  // namespace
}  // namespace bw::safety
