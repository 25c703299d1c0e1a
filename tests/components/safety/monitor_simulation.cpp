#include "tests/components/safety/monitor_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

#include "components/model/footprint_distance.hpp"
#include "components/motor_control/velocity_limiter.hpp"
#include "components/safety/collision_monitor.hpp"
#include "tests/components/safety/monitor_driver.hpp"
#include "tests/components/safety/monitor_laser.hpp"

namespace bw::safety::test {
namespace {

constexpr double kStep = 0.005;     // [s] of the world
constexpr int kCycle = 4;           // steps of odometry, monitor and motor control
constexpr double kStanding = 0.02;  // [m/s]
constexpr double kAhead = 0.6;      // [rad], of the way it goes

/// Where a robot touches a thing: at the corner that is in it, else what of the thing is nearest to base_link.
Vector2 touched(const Footprint& outline, const Pose2& X_WB, const Capsule& thing) {
  for (const Vector2& corner : outline.polygon) {
    const Vector2 at = X_WB * corner;
    if (distance_to(at, thing).distance < 0.0) return place_near(thing, at);
  }
  return place_near(thing, X_WB.position());
}

/// What happens between the robot and the things around it.
class Judge {
 public:
  Judge(const Footprint& outline, const Laser& laser, std::vector<Capsule> things)
      : outline_(outline), laser_(laser), things_(std::move(things)), contacts_(things_.size()) {}

  void heard(Laser::Sweep sweep) { sweeps_.push_back(std::move(sweep)); }
  void look(double t, const Pose2& X_WB, const Twist2& twist, Result& result) {
    while (!sweeps_.empty() && sweeps_.front().middle() < t - 1.0) sweeps_.pop_front();
    for (std::size_t i = 0; i < things_.size(); ++i) {
      const FootprintDistance d = distance_to(outline_, X_WB, things_[i]);
      if (d.distance >= 0.0) {
        contacts_[i] = nullptr;
        continue;
      }
      if (contacts_[i] == nullptr) contacts_[i] = kind_of(touched(outline_, X_WB, things_[i]), X_WB, twist);
      double& worst = result.*contacts_[i];
      worst = std::max(worst, -(d.gradient.dot(twist.v * direction(X_WB.theta)) + d.turn * twist.omega));
    }
  }

 private:
  using Kind = double Result::*;

  Kind kind_of(const Vector2& place, const Pose2& X_WB, const Twist2& twist) const {
    const auto of_all = [&](bool (Laser::*says)(const Laser::Sweep&, const Vector2&) const) {
      return !sweeps_.empty() &&
             std::ranges::all_of(sweeps_, [&](const auto& sweep) { return (laser_.*says)(sweep, place); });
    };
    if (of_all(&Laser::shows)) return &Result::worst;
    if (!of_all(&Laser::is_blind_to)) return &Result::hidden;
    if (std::abs(twist.v) < kStanding) return &Result::turned_into;
    const Vector2 way = inverse(X_WB) * place;
    const bool is_ahead = std::abs(twist.v) >= outline_.radius * std::abs(twist.omega) &&
                          std::abs(std::atan2(way.y(), std::copysign(way.x(), way.x() * twist.v))) < kAhead;
    return is_ahead ? &Result::ahead : &Result::swept;
  }

  const Footprint& outline_;
  const Laser& laser_;
  std::vector<Capsule> things_;
  std::vector<Kind> contacts_;
  std::deque<Laser::Sweep> sweeps_;
};

}  // namespace

Result run(const Scene& scene) {
  const auto& n = scene.numbers;
  const Robot robot = robot_of(scene);
  const Footprint outline = robot.outline();
  CollisionMonitorOptions options;
  // The premise: what the robot file says of the reaction is no less than it is: a cycle of each, the wheels, one step.
  options.stopping.reaction_time = std::max(0.1, n[kDelay] + 2.0 * kCycle * kStep + 0.02);
  options.source_timeout = std::max(0.25, 2.5 * n[kPeriod]);
  CollisionMonitor monitor(robot, options);
  VelocityLimiter limiter(robot, {});
  std::vector<Capsule> things;
  for (const Thing& thing : scene.things) things.push_back(shape_of(thing));
  Laser laser(scene);
  Judge judge(outline, laser, things);
  Driver driver(scene);
  const double turning = n[kTurns] * n[kPeriod];
  const StampSource writer{.is_own_clock = n[kClock] == 0.0,
                           .delay = Duration::seconds(0.5 * turning + n[kAge])};
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
      judge.heard(std::move(under_way.front()));
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
    judge.look(t, X_WB, twist, result);
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
                                    kLaserHeading, kTurns, kClock, kDrift})
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
      for (double Thing::*part : {&Thing::x, &Thing::y, &Thing::p, &Thing::q})
        attempt([&](Scene& s) { s.things[i].*part = std::round(s.things[i].*part * 100.0) / 100.0; });
  }
  return scene;
}

}  // namespace bw::safety::test
