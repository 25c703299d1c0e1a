#include "tests/components/safety/monitor_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <stdexcept>

#include "components/model/random.hpp"

namespace bw::safety::test {
namespace {

constexpr double kThick = 0.01;  // [m], half of a wall

/// In two scenes of five: one or two who walk, most of them at the robot, and some of those stop.
void add_people(Random& random, const Footprint& outline, Scene& scene) {
  const double share = random.uniform();
  const int count = share < 0.6 ? 0 : share < 0.85 ? 1 : 2;
  for (int i = 0; i < count;) {
    const Vector2 at =
        random.uniform(0.4, 3.0) * direction(random.uniform(-std::numbers::pi, std::numbers::pi));
    const double aside = random.uniform() < 0.7 ? random.uniform(-0.4, 0.4)
                                                : random.uniform(-std::numbers::pi, std::numbers::pi);
    const Vector2 v = random.uniform(0.2, 1.6) * direction(std::atan2(-at.y(), -at.x()) + aside);
    const Thing person{.x = at.x(),
                       .y = at.y(),
                       .p = random.uniform(0.06, 0.3),
                       .vx = v.x(),
                       .vy = v.y(),
                       .until = random.uniform(0.5, 8.0)};
    if (!is_apart(outline, person)) continue;
    scene.things.push_back(person);
    ++i;
  }
}

}  // namespace

Capsule shape_of(const Thing& thing, double t) {
  const Vector2 moved = std::min(t, thing.until) * Vector2(thing.vx, thing.vy);
  const Vector2 a = Vector2(thing.x, thing.y) + moved;
  return thing.is_wall != 0.0 ? Capsule{a, Vector2(thing.p, thing.q) + moved, kThick}
                              : Capsule{a, a, thing.p};
}

bool is_apart(const Footprint& outline, const Thing& thing) {
  return gap_to(outline, {}, shape_of(thing, 0.0)) > 0.02;
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
                  .alpha_max = n[kAngularAcceleration],
                  .jerk_max = 10.0,
                  .stop_deceleration = n[kDeceleration]};
  Footprint outline;
  if (n[kShape] == 1.0) {
    outline.polygon = {
        {n[kFront], n[kWidth]}, {-n[kBack], n[kWidth]}, {-n[kBack], -n[kWidth]}, {n[kFront], -n[kWidth]}};
  } else if (n[kShape] == 2.0) {
    for (int i = 0; i < static_cast<int>(n[kCorners]); ++i) {
      const Vector2 u = direction(2.0 * std::numbers::pi * i / n[kCorners]);
      outline.polygon.emplace_back(u.x() * (u.x() > 0.0 ? n[kFront] : n[kBack]), u.y() * n[kWidth]);
    }
  }
  if (outline.is_polygon()) robot.footprint = to_text(outline);
  return robot;
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
  n[kAngularAcceleration] = random.uniform(0.8, 6.0);
  n[kSeparation] = random.uniform(0.2, 0.5);
  n[kLaserX] = random.uniform(-0.08, 0.1);
  n[kLaserHeading] = pick({0.0, 0.0, std::numbers::pi});
  n[kField] = pick({2.0 * std::numbers::pi, 2.0 * std::numbers::pi, 1.5 * std::numbers::pi, std::numbers::pi,
                    0.5 * std::numbers::pi});
  n[kBeams] = std::ceil(n[kField] / (std::numbers::pi / 180.0) * pick({1.0, 1.0, 2.0}));
  n[kPeriod] = 1.0 / random.uniform(5.0, 40.0);
  n[kAge] = random.uniform(0.0, 0.15);
  n[kNoise] = pick({0.0, 0.005, 0.01});
  n[kDropout] = pick({0.0, 0.0, 0.05});
  n[kRange] = random.uniform(4.0, 20.0);
  n[kBlindAt] = random.uniform(-std::numbers::pi, std::numbers::pi);
  n[kBlindWidth] = pick({0.0, 0.0, 0.3});
  n[kDarkFrom] = random.uniform(0.5, 4.0);
  n[kDarkAt] = random.uniform(-std::numbers::pi, std::numbers::pi);
  n[kDarkWidth] = pick({0.0, 0.0, 0.0, 1.0, 2.0});
  n[kDelay] = random.uniform(0.0, 0.1);
  n[kDriver] = static_cast<double>(random.bits() % 6);
  n[kSeed] = static_cast<double>(random.bits() % 100'000);
  n[kSeconds] = 4.0;
  n[kCommandPeriod] = pick({0.02, 0.1, 0.5, 1.5});
  Random other(seed + 1'000'000'007);  // so that the numbers above stay what they are
  n[kSweepShare] = other.uniform() < 0.3 ? 0.9 : 0.0;
  if (other.uniform() < 0.3) {
    n[kClock] = other.uniform(-1000.0, 1000.0);
    n[kDrift] = other.uniform(-5e-4, 5e-4);
  }
  const Footprint outline = robot_of(scene).outline();
  const std::size_t count = 1 + random.bits() % 5;
  while (scene.things.size() < count) {
    const Vector2 a =
        random.uniform(0.15, 2.0) * direction(random.uniform(-std::numbers::pi, std::numbers::pi));
    const double is_wall = random.uniform() < 0.4 ? 1.0 : 0.0;
    Thing thing{.is_wall = is_wall, .x = a.x(), .y = a.y(), .p = random.uniform(0.06, 0.4)};
    if (thing.is_wall != 0.0) {
      const Vector2 b =
          a + random.uniform(0.3, 4.0) * direction(random.uniform(-std::numbers::pi, std::numbers::pi));
      thing.p = b.x();
      thing.q = b.y();
    }
    if (is_apart(outline, thing)) scene.things.push_back(thing);
  }
  add_people(other, outline, scene);
  return scene;
}

std::string to_text(const Scene& scene) {
  std::ostringstream text;
  text.precision(6);
  for (const double number : scene.numbers) text << number << ' ';
  for (const Thing& thing : scene.things)
    text << "| " << thing.is_wall << ' ' << thing.x << ' ' << thing.y << ' ' << thing.p << ' ' << thing.q
         << ' ' << thing.vx << ' ' << thing.vy << ' ' << thing.until << ' ';
  return text.str();
}

Scene scene_of(const std::string& line) {
  std::istringstream text(line);
  Scene scene;
  for (double& number : scene.numbers)
    if (!(text >> number)) throw std::invalid_argument("a scene has too few numbers: " + line);
  for (std::string bar; text >> bar;) {
    Thing thing;
    if (!(text >> thing.is_wall >> thing.x >> thing.y >> thing.p >> thing.q >> thing.vx >> thing.vy >>
          thing.until))
      throw std::invalid_argument("a thing has eight numbers: " + line);
    scene.things.push_back(thing);
  }
  return scene;
}

}  // namespace bw::safety::test
