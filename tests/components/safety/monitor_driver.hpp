// Who drives a robot of the monitor's property test: never of good will.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "components/model/random.hpp"
#include "runtime/base/pose2.hpp"
#include "tests/components/safety/monitor_scene.hpp"

namespace bw::safety::test {

/// Nearest point of a thing's rim to `p`.
inline Vector2 point_near(const Capsule& thing, const Vector2& p) {
  const Vector2 side = thing.b - thing.a;
  const double squared = side.squaredNorm();
  const double share = squared > 0.0 ? std::clamp(side.dot(p - thing.a) / squared, 0.0, 1.0) : 0.0;
  const Vector2 middle = thing.a + share * side;
  const Vector2 out = p - middle;
  return middle + out * (thing.radius / std::max(out.norm(), 1e-9));
}

class Driver {
 public:
  explicit Driver(const Scene& scene)
      : numbers_(scene.numbers), random_(static_cast<std::uint64_t>(numbers_[kSeed]) + 77) {}

  Twist2 command(double t, const Pose2& X_WB, const std::vector<Capsule>& things) {
    if (t < next_) return command_;
    next_ = t + numbers_[kCommandPeriod];
    const double v = numbers_[kSpeed];
    const double turn_rate = numbers_[kTurnRate];
    switch (static_cast<int>(numbers_[kDriver])) {
      case 0:  // random, held
        return command_ = {random_.uniform(-numbers_[kSpeedBack], v), random_.uniform(-turn_rate, turn_rate)};
      case 1:  // at what is nearest, forward
      case 2:  // and backward
        return command_ = aim(X_WB, things, numbers_[kDriver] == 1.0);
      case 3:  // on the spot, this way and that
        if (random_.uniform() < 0.1 || command_ == Twist2{})
          command_ = {0.0, random_.uniform() < 0.5 ? turn_rate : -turn_rate};
        return command_;
      case 4:  // full speed, and rotations that switch
        return command_ = {v, random_.uniform() < 0.5 ? turn_rate : -turn_rate};
      default:  // any of the ends
        return command_ = {random_.uniform() < 0.5   ? v
                           : random_.uniform() < 0.5 ? -numbers_[kSpeedBack]
                                                     : 0.0,
                           std::array{-turn_rate, 0.0, turn_rate}[random_.bits() % 3]};
    }
  }

 private:
  Twist2 aim(const Pose2& X_WB, const std::vector<Capsule>& things, bool is_forward) {
    Vector2 target(1.0, 0.0);
    double nearest = std::numeric_limits<double>::infinity();
    for (const Capsule& thing : things) {
      const Vector2 p = inverse(X_WB) * point_near(thing, X_WB.position());
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

}  // namespace bw::safety::test
