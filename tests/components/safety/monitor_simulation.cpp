#include "tests/components/safety/monitor_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "components/motor_control/velocity_limiter.hpp"
#include "components/safety/collision_monitor.hpp"
#include "tests/components/safety/monitor_driver.hpp"
#include "tests/components/safety/monitor_judge.hpp"
#include "tests/components/safety/monitor_laser.hpp"

namespace bw::safety::test {
namespace {

constexpr double kStep = 0.005;  // [s] of the world
constexpr int kCycle = 4;        // steps of odometry, monitor and motor control

}  // namespace

Result run(const Scene& scene) {
  const auto& n = scene.numbers;
  const Robot robot = robot_of(scene);
  CollisionMonitorOptions options;
  // The premise: what the robot file says of the reaction is no less than it is: a cycle of each, the wheels,
  // one step.
  options.stopping.reaction_time = std::max(0.1, n[kDelay] + 2.0 * kCycle * kStep + 0.02);
  options.source_timeout = std::max(0.25, 2.5 * n[kPeriod]);
  CollisionMonitor monitor(robot, options);
  VelocityLimiter limiter(robot, {});
  std::vector<Capsule> things(scene.things.size());
  Laser laser(scene);
  Judge judge(scene, robot, laser, options.stopping.reaction_time);
  Driver driver(scene);
  const double sweep_time = n[kSweepShare] * n[kPeriod];
  const StampSource writer{.is_own_clock = n[kClock] == 0.0,
                           .delay = Duration::seconds(0.5 * sweep_time + n[kAge])};
  std::optional<Laser::Sweep> begun;
  std::deque<Laser::Sweep> under_way;
  std::deque<std::pair<double, Twist2>> wheels;
  Pose2 X_WB;
  Twist2 twist;
  Result result;
  double next_sweep = 0.0;
  const int steps = static_cast<int>(n[kSeconds] / kStep);
  for (int i = 0; i < steps; ++i) {
    const double t = i * kStep;
    const Time now = Time::seconds(100.0 + t);
    std::ranges::transform(scene.things, things.begin(),
                           [&](const auto& thing) { return shape_of(thing, t); });
    if (t >= next_sweep) {
      next_sweep += n[kPeriod];
      begun = laser.begin(t);
    }
    if (begun && laser.go_on(*begun, t, X_WB, things)) {
      under_way.push_back(std::move(*begun));
      begun.reset();
    }
    if (i % kCycle == 0) monitor.odometry(now, X_WB, twist);
    while (!under_way.empty() && t >= under_way.front().ended + n[kAge]) {
      monitor.sweep(now, laser.view(under_way.front()), writer);
      judge.heard(t, std::move(under_way.front()), X_WB, twist);
      under_way.pop_front();
    }
    if (i % kCycle == 0) {
      const Verdict verdict = monitor.judge(now, driver.command(t, X_WB, things));
      limiter.set_braking(verdict.action == Action::do_nothing ? Braking::smooth : Braking::hard);
      limiter.command(now, verdict.allowed);
      wheels.emplace_back(t + n[kDelay], limiter.step(now).twist);
    }
    while (!wheels.empty() && wheels.front().first <= t) {
      twist = wheels.front().second;
      wheels.pop_front();
    }
    judge.look(t, X_WB, twist, things, result);
    X_WB = advance_exact(X_WB, twist, kStep);
    result.driven += std::abs(twist.v) * kStep;
  }
  return result;
}

Scene shrunk(Scene scene, const std::function<double(const Result&)>& excess) {
  const auto still_fails = [&](const Scene& smaller) {
    const Scene written = scene_of(to_text(smaller));
    const Footprint outline = robot_of(written).outline();
    return std::ranges::all_of(written.things,
                               [&](const Thing& thing) { return is_apart(outline, thing); }) &&
           excess(run(written)) > 0.0;
  };
  const auto attempt = [&](const std::function<void(Scene&)>& change) {
    Scene smaller = scene;
    change(smaller);
    if (to_text(smaller) == to_text(scene) || !still_fails(smaller)) return false;
    scene = smaller;
    return true;
  };
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    for (std::size_t i = scene.things.size(); i-- > 0;)
      has_changed |=
          attempt([i](Scene& s) { s.things.erase(s.things.begin() + static_cast<std::ptrdiff_t>(i)); });
    for (const std::size_t extra : {kNoise, kDropout, kBlindWidth, kDarkWidth, kAge, kDelay, kLaserX,
                                    kLaserHeading, kSweepShare, kClock, kDrift})
      has_changed |= attempt([extra](Scene& s) { s.numbers[extra] = 0.0; });
    for (const double less : {0.5, 0.1, 0.02})
      has_changed |= attempt([less](Scene& s) { s.numbers[kSeconds] -= less; });
    for (std::size_t i = 0; i < kNumbers; ++i) {
      if (i == kSeconds) continue;  // it would be made longer and shorter for ever
      for (const double digits : {1.0, 10.0, 100.0})
        if (std::round(scene.numbers[i] * digits) != 0.0 &&
            attempt([&](Scene& s) { s.numbers[i] = std::round(s.numbers[i] * digits) / digits; }))
          break;
    }
    for (std::size_t i = 0; i < scene.things.size(); ++i)
      for (double Thing::*part :
           {&Thing::x, &Thing::y, &Thing::p, &Thing::q, &Thing::vx, &Thing::vy, &Thing::until})
        attempt([&](Scene& s) { s.things[i].*part = std::round(s.things[i].*part * 100.0) / 100.0; });
  }
  return scene;
}

}  // namespace bw::safety::test
