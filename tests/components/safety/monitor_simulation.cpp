#include "tests/components/safety/monitor_simulation.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "components/model/footprint_distance.hpp"
#include "components/model/random.hpp"
#include "components/motor_control/velocity_limiter.hpp"
#include "components/safety/collision_monitor.hpp"

namespace bw::safety::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStep = 0.005;  // [s] of the world
constexpr int kCycle = 4;        // steps of odometry, monitor and motor control
constexpr double kThick = 0.01;  // [m], half of a wall
constexpr float kNothing = std::numeric_limits<float>::infinity();
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

Capsule shape_of(const Thing& thing) {
  const Vector2 a(thing.x, thing.y);
  return thing.is_wall != 0.0 ? Capsule{a, {thing.p, thing.q}, kThick} : Capsule{a, a, thing.p};
}

/// Along unit vector `u` from `from` to the rim of a disc.
double to_disc(const Vector2& from, const Vector2& u, const Vector2& center, double radius) {
  const Vector2 way = center - from;
  const double along = way.dot(u);
  const double off = cross(u, way);
  const double under_root = radius * radius - off * off;
  if (under_root <= 0.0 || along <= 0.0) return std::numeric_limits<double>::infinity();
  return std::max(0.0, along - std::sqrt(under_root));
}

double to_thing(const Vector2& from, const Vector2& u, const Capsule& thing) {
  double range = std::min(to_disc(from, u, thing.a, thing.radius), to_disc(from, u, thing.b, thing.radius));
  const Vector2 side = thing.b - thing.a;
  const double length = side.norm();
  if (length == 0.0) return range;
  for (const double sign : {-1.0, 1.0}) {
    const Vector2 a = thing.a + Vector2(-side.y(), side.x()) / length * (sign * thing.radius);
    const double slant = cross(u, side);
    if (slant == 0.0) continue;
    const double along = cross(a - from, side) / slant;
    const double share = cross(a - from, u) / slant;
    if (along > 0.0 && share >= 0.0 && share <= 1.0) range = std::min(range, along);
  }
  return range;
}

/// Nearest place of a thing's rim to `p`.
Vector2 place_near(const Capsule& thing, const Vector2& p) {
  const Vector2 side = thing.b - thing.a;
  const double squared = side.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(side.dot(p - thing.a) / squared, 0.0, 1.0) : 0.0;
  const Vector2 middle = thing.a + share * side;
  const Vector2 out = p - middle;
  return middle + out * (thing.radius / std::max(out.norm(), 1e-9));
}

/// Where a robot touches a thing: at the corner that is in it, else what of the thing is nearest to base_link.
Vector2 touched(const Footprint& outline, const Pose2& X_WB, const Capsule& thing) {
  for (const Vector2& corner : outline.polygon) {
    const Vector2 at = X_WB * corner;
    if (distance_to(at, thing).distance < 0.0) return place_near(thing, at);
  }
  return place_near(thing, X_WB.position());
}

Robot robot_of(const Scene& scene) {
  const auto& n = scene.numbers;
  Robot robot;
  robot.radius = n[kFront];
  robot.wheel_separation = n[kSeparation];
  robot.wheel_speed_max = n[kSpeed] + 0.5 * n[kSeparation] * n[kTurnRate];
  robot.limits = {.v_max = n[kSpeed],
                  .v_back_max = n[kSpeedBack],
                  .omega_max = n[kTurnRate],
                  .acc_max = n[kAcceleration],
                  .alpha_max = n[kTurnAcceleration],
                  .jerk_max = 10.0,
                  .stop_deceleration = n[kDeceleration]};
  Footprint outline;
  if (n[kShape] == 1.0) {
    outline.polygon = {
        {n[kFront], n[kWidth]}, {-n[kBack], n[kWidth]}, {-n[kBack], -n[kWidth]}, {n[kFront], -n[kWidth]}};
  } else if (n[kShape] == 2.0) {
    for (int i = 0; i < static_cast<int>(n[kCorners]); ++i) {
      const Vector2 u = direction(2.0 * kPi * i / n[kCorners]);
      outline.polygon.emplace_back(u.x() * (u.x() > 0.0 ? n[kFront] : n[kBack]), u.y() * n[kWidth]);
    }
  }
  if (outline.is_polygon()) robot.footprint = to_text(outline);
  return robot;
}

/// What drives: never of good will.
class Driver {
 public:
  explicit Driver(const Scene& scene)
      : numbers_(scene.numbers), random_(static_cast<std::uint64_t>(numbers_[kSeed]) + 77) {}

  Twist2 command(double t, const Pose2& X_WB, const std::vector<Capsule>& things) {
    if (t < next_) return command_;
    next_ = t + numbers_[kCommandPeriod];
    const double v = numbers_[kSpeed];
    const double turn = numbers_[kTurnRate];
    switch (static_cast<int>(numbers_[kDriver])) {
      case 0:  // random, held
        return command_ = {random_.uniform(-numbers_[kSpeedBack], v), random_.uniform(-turn, turn)};
      case 1:  // at what is nearest, forward
      case 2:  // and backward
        return command_ = aim(X_WB, things, numbers_[kDriver] == 1.0);
      case 3:  // on the spot, this way and that
        if (random_.uniform() < 0.1 || command_ == Twist2{})
          command_ = {0.0, random_.uniform() < 0.5 ? turn : -turn};
        return command_;
      case 4:  // full speed, and turns that switch
        return command_ = {v, random_.uniform() < 0.5 ? turn : -turn};
      default:  // any of the ends
        return command_ = {random_.uniform() < 0.5   ? v
                           : random_.uniform() < 0.5 ? -numbers_[kSpeedBack]
                                                     : 0.0,
                           std::array{-turn, 0.0, turn}[random_.bits() % 3]};
    }
  }

 private:
  Twist2 aim(const Pose2& X_WB, const std::vector<Capsule>& things, bool is_forward) {
    Vector2 target(1.0, 0.0);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Capsule& thing : things) {
      const Vector2 p = inverse(X_WB) * place_near(thing, X_WB.position());
      if (p.norm() < nearest) {
        nearest = p.norm();
        target = p;
      }
    }
    const double bearing =
        is_forward ? std::atan2(target.y(), target.x()) : std::atan2(-target.y(), -target.x());
    const double omega = std::clamp(4.0 * bearing, -numbers_[kTurnRate], numbers_[kTurnRate]);
    return {is_forward ? numbers_[kSpeed] : -numbers_[kSpeedBack], omega};
  }

  const std::array<double, kNumbers>& numbers_;
  Random random_;
  double next_ = 0.0;
  Twist2 command_;
};

class Laser {
 public:
  explicit Laser(const Scene& scene)
      : numbers_(scene.numbers),
        random_(static_cast<std::uint64_t>(numbers_[kSeed])),
        X_BL_{numbers_[kLaserX], 0.0, numbers_[kLaserHeading]} {}

  struct Sweep {
    double at = 0.0;
    Pose2 X_WL;
    std::vector<float> ranges;
  };

  Sweep scan(double t, const Pose2& X_WB, const std::vector<Capsule>& things) {
    Sweep sweep{t, X_WB * X_BL_, {}};
    const auto beams = static_cast<int>(numbers_[kBeams]);
    for (int i = 0; i < beams; ++i) sweep.ranges.push_back(range(angle_of(i), t, sweep.X_WL, things));
    return sweep;
  }
  LaserSweep view(const Sweep& sweep) const {
    return {.time = Time::seconds(100.0 + sweep.at),
            .X_FL = X_BL_,
            .angle_min = angle_of(0),
            .angle_increment = increment(),
            .range_min = 0.02,
            .range_max = numbers_[kRange],
            .ranges = sweep.ranges};
  }
  /// Whether a sweep shows `place` (world): in the field, the first thing in the way, and no lost beam.
  bool shows(const Sweep& sweep, const Vector2& place) const {
    const Vector2 p_L = inverse(sweep.X_WL) * place;
    const double off = wrap_angle(std::atan2(p_L.y(), p_L.x()) - angle_of(0));
    const double beam = (off < 0.0 ? off + 2.0 * kPi : off) / increment();
    int shown = 0;
    for (int i = -2; i <= 2; ++i) {
      auto at = static_cast<std::ptrdiff_t>(std::lround(beam)) + i;
      if (is_round()) at = (at + std::ssize(sweep.ranges)) % std::ssize(sweep.ranges);
      if (at < 0 || at >= std::ssize(sweep.ranges)) return false;
      if (std::abs(sweep.ranges[static_cast<std::size_t>(at)] - p_L.norm()) < 0.05 + 5.0 * numbers_[kNoise])
        ++shown;
    }
    return shown >= 4;
  }

 private:
  bool is_round() const { return numbers_[kField] > 6.28; }
  double increment() const { return numbers_[kField] / (numbers_[kBeams] - (is_round() ? 0.0 : 1.0)); }
  double angle_of(int beam) const { return -0.5 * numbers_[kField] + beam * increment(); }
  float range(double angle, double t, const Pose2& X_WL, const std::vector<Capsule>& things) {
    const bool is_lost = random_.uniform() < numbers_[kDropout];
    const double noise = numbers_[kNoise] * std::clamp(random_.normal(), -3.0, 3.0);
    if (is_lost || std::abs(wrap_angle(angle - numbers_[kBlindAt])) < 0.5 * numbers_[kBlindWidth])
      return kUnknown;
    if (t > numbers_[kDarkFrom] &&
        std::abs(wrap_angle(angle - numbers_[kDarkAt])) < 0.5 * numbers_[kDarkWidth])
      return kNothing;
    const Vector2 u = direction(X_WL.theta + angle);
    double range = std::numeric_limits<double>::infinity();
    for (const Capsule& thing : things) range = std::min(range, to_thing(X_WL.position(), u, thing));
    if (range >= numbers_[kRange]) return kNothing;
    return static_cast<float>(std::clamp(range + noise, 0.021, numbers_[kRange]));
  }

  const std::array<double, kNumbers>& numbers_;
  Random random_;
  Pose2 X_BL_;
};

bool is_apart(const Footprint& outline, const Thing& thing) {
  return gap_to(outline, {}, shape_of(thing)) > 0.02;
}

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
  Driver driver(scene);
  std::deque<Laser::Sweep> under_way;
  std::deque<Laser::Sweep> seen;
  std::deque<std::pair<double, Twist2>> wheels;
  Pose2 X_WB;
  Twist2 twist;
  Result result;
  double next_sweep = 0.0;
  const auto was_seen = [&](const Vector2& place) {
    return !seen.empty() &&
           std::ranges::all_of(seen, [&](const auto& sweep) { return laser.shows(sweep, place); });
  };
  const int steps = static_cast<int>(n[kSeconds] / kStep);
  for (int i = 0; i < steps; ++i) {
    const double t = i * kStep;
    const Time now = Time::seconds(100.0 + t);
    if (t >= next_sweep) {
      next_sweep += n[kPeriod];
      under_way.push_back(laser.scan(t, X_WB, things));
    }
    if (i % kCycle == 0) monitor.odometry(now, X_WB, twist);
    while (!under_way.empty() && t >= under_way.front().at + n[kAge]) {
      monitor.sweep(now, laser.view(under_way.front()));
      seen.push_back(std::move(under_way.front()));
      under_way.pop_front();
    }
    while (!seen.empty() && seen.front().at < t - 1.0) seen.pop_front();
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
    for (const Capsule& thing : things) {
      const FootprintDistance d = distance_to(outline, X_WB, thing);
      if (d.distance >= 0.0) continue;
      const double closing = -(d.gradient.dot(twist.v * direction(X_WB.theta)) + d.turn * twist.omega);
      double& worst = was_seen(touched(outline, X_WB, thing)) ? result.worst : result.unseen;
      if (closing > worst) {
        worst = closing;
        if (&worst == &result.worst) result.at = t;
      }
    }
    X_WB = advance_exact(X_WB, twist, kStep);
    result.driven += std::abs(twist.v) * kStep;
  }
  return result;
}

Scene random_scene(std::uint64_t seed) {
  Random random(seed);
  const auto pick = [&](std::initializer_list<double> of) {
    return *(of.begin() + random.bits() % of.size());
  };
  Scene scene;
  auto& n = scene.numbers;
  n[kShape] = pick({0.0, 1.0, 1.0, 2.0});
  n[kFront] = random.uniform(0.12, 0.5);
  n[kBack] = random.uniform(0.12, 0.9);
  n[kWidth] = random.uniform(0.1, 0.4);
  n[kCorners] = 3.0 + static_cast<double>(random.bits() % 9);
  n[kSpeed] = random.uniform(0.2, 1.5);
  n[kSpeedBack] = random.uniform(0.05, 0.6);
  n[kTurnRate] = random.uniform(0.3, 3.0);
  n[kDeceleration] = random.uniform(1.0, 4.0);
  n[kAcceleration] = n[kDeceleration] * random.uniform(0.3, 1.0);
  n[kTurnAcceleration] = random.uniform(0.8, 6.0);
  n[kSeparation] = random.uniform(0.2, 0.5);
  n[kLaserX] = random.uniform(-0.08, 0.1);
  n[kLaserHeading] = pick({0.0, 0.0, kPi});
  n[kField] = pick({2.0 * kPi, 2.0 * kPi, 1.5 * kPi, kPi, 0.5 * kPi});
  n[kBeams] = std::ceil(n[kField] / (kPi / 180.0) * pick({1.0, 1.0, 2.0}));
  n[kPeriod] = 1.0 / random.uniform(5.0, 40.0);
  n[kAge] = random.uniform(0.0, 0.15);
  n[kNoise] = pick({0.0, 0.005, 0.01});
  n[kDropout] = pick({0.0, 0.0, 0.05});
  n[kRange] = random.uniform(4.0, 20.0);
  n[kBlindAt] = random.uniform(-kPi, kPi);
  n[kBlindWidth] = pick({0.0, 0.0, 0.3});
  n[kDarkFrom] = random.uniform(0.5, 4.0);
  n[kDarkAt] = random.uniform(-kPi, kPi);
  n[kDarkWidth] = pick({0.0, 0.0, 0.0, 1.0, 2.0});
  n[kDelay] = random.uniform(0.0, 0.1);
  n[kDriver] = static_cast<double>(random.bits() % 6);
  n[kSeed] = static_cast<double>(random.bits() % 100'000);
  n[kSeconds] = 4.0;
  n[kCommandPeriod] = pick({0.02, 0.1, 0.5, 1.5});
  const Footprint outline = robot_of(scene).outline();
  const std::size_t count = 1 + random.bits() % 5;
  while (scene.things.size() < count) {
    const Vector2 a = random.uniform(0.15, 2.0) * direction(random.uniform(-kPi, kPi));
    Thing thing{random.uniform() < 0.4 ? 1.0 : 0.0, a.x(), a.y(), random.uniform(0.06, 0.4), 0.0};
    if (thing.is_wall != 0.0) {
      const Vector2 b = a + random.uniform(0.3, 4.0) * direction(random.uniform(-kPi, kPi));
      thing.p = b.x();
      thing.q = b.y();
    }
    if (is_apart(outline, thing)) scene.things.push_back(thing);
  }
  return scene;
}

std::string to_text(const Scene& scene) {
  std::ostringstream text;
  text.precision(6);
  for (const double number : scene.numbers) text << number << ' ';
  for (const Thing& thing : scene.things)
    text << "| " << thing.is_wall << ' ' << thing.x << ' ' << thing.y << ' ' << thing.p << ' ' << thing.q
         << ' ';
  return text.str();
}

Scene scene_of(const std::string& line) {
  std::istringstream text(line);
  Scene scene;
  for (double& number : scene.numbers)
    if (!(text >> number)) throw std::invalid_argument("a scene has too few numbers: " + line);
  for (std::string bar; text >> bar;) {
    Thing thing;
    if (!(text >> thing.is_wall >> thing.x >> thing.y >> thing.p >> thing.q))
      throw std::invalid_argument("a thing has five numbers: " + line);
    scene.things.push_back(thing);
  }
  return scene;
}

Scene shrunk(Scene scene, double speed) {
  const auto still_fails = [&](const Scene& smaller) {
    const Scene written = scene_of(to_text(smaller));
    const Footprint outline = robot_of(written).outline();
    return std::ranges::all_of(written.things,
                               [&](const Thing& thing) { return is_apart(outline, thing); }) &&
           run(written).worst > speed;
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
    for (const std::size_t extra :
         {kNoise, kDropout, kBlindWidth, kDarkWidth, kAge, kDelay, kLaserX, kLaserHeading})
      has_changed |= attempt([extra](Scene& s) { s.numbers[extra] = 0.0; });
    const double end = run(scene).at + 0.02;
    has_changed |= attempt([end](Scene& s) { s.numbers[kSeconds] = std::min(s.numbers[kSeconds], end); });
    for (std::size_t i = 0; i < kNumbers; ++i) {
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
