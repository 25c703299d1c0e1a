// A pose that moves many points: its sine and cosine are computed once.
#pragma once

#include "runtime/base/pose2.hpp"

namespace bw {

class Transform2 {
 public:
  explicit Transform2(const Pose2& X_AB)
      : x_(X_AB.x), y_(X_AB.y), c_(std::cos(X_AB.theta)), s_(std::sin(X_AB.theta)) {}

  /// p_A of p_B, bit by bit what X_AB * p_B is.
  Vector2 operator*(const Vector2& p_B) const {
    return {x_ + c_ * p_B.x() - s_ * p_B.y(), y_ + s_ * p_B.x() + c_ * p_B.y()};
  }

 private:
  double x_, y_, c_, s_;
};

}  // namespace bw
