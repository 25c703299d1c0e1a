// What a push does to somebody: a velocity beside their own that decays, as people regain the velocity they
// want.
#pragma once

#include <cmath>

#include "runtime/base/pose2.hpp"

namespace bw {

class Push {
 public:
  /// `decay_time` [s] in which the velocity falls to 1/e; so a push of v moves somebody by v times that.
  explicit Push(double decay_time) : decay_time_(decay_time) {}

  void add(const Vector2& velocity_change) { velocity_ += velocity_change; }
  /// Where it moves somebody in `dt` [s].
  Vector2 step(double dt) {
    const double left = std::exp(-dt / decay_time_);
    const Vector2 displacement = velocity_ * (decay_time_ * (1.0 - left));
    velocity_ *= left;
    if (velocity_.norm() < kOver) velocity_ = {0.0, 0.0};
    return displacement;
  }
  void stop() { velocity_ = {0.0, 0.0}; }
  bool is_over() const { return velocity_ == Vector2(0.0, 0.0); }
  const Vector2& velocity() const { return velocity_; }

 private:
  static constexpr double kOver = 1e-3;  // [m/s]

  double decay_time_;
  Vector2 velocity_{0.0, 0.0};
};

}  // namespace bw
