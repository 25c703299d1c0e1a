// Rotation and shift that carry points of one frame onto points of another, least squares (Umeyama 1991), from running
// sums: how a path by wheels lies in the map when positions along it are known.
#pragma once

#include <algorithm>
#include <cmath>

#include "runtime/base/pose2.hpp"

namespace bw {

class RigidFit {
 public:
  /// Adds the pair p_A = X_AB * p_B. Sums are about the first pair, so that far origins cost no digits.
  void add(const Vector2& p_A, const Vector2& p_B) {
    if (count_ == 0) {
      origin_A_ = p_A;
      origin_B_ = p_B;
    }
    const Vector2 a = p_A - origin_A_;
    const Vector2 b = p_B - origin_B_;
    ++count_;
    sum_a_ += a;
    sum_b_ += b;
    dot_ += a.dot(b);
    cross_ += cross(b, a);
    squares_b_ += b.squaredNorm();
  }

  int count() const { return count_; }
  Vector2 mean_A() const { return origin_A_ + sum_a_ / std::max(1, count_); }
  Vector2 mean_B() const { return origin_B_ + sum_b_ / std::max(1, count_); }

  /// Sum of squared distances [m^2] of the points in B from their mean; variance of angle() is that of a
  /// position (one axis) over this.
  double spread() const {
    return count_ == 0 ? 0.0 : std::max(0.0, squares_b_ - sum_b_.squaredNorm() / count_);
  }

  /// Heading of B in A [rad]; 0 when the points do not tell.
  double angle() const {
    const int n = std::max(1, count_);
    const double c = dot_ - sum_a_.dot(sum_b_) / n;
    const double s = cross_ - cross(sum_b_, sum_a_) / n;
    return c == 0.0 && s == 0.0 ? 0.0 : std::atan2(s, c);
  }

  Pose2 X_AB() const {
    const double theta = angle();
    const Vector2 shift = mean_A() - rotate({0.0, 0.0, theta}, mean_B());
    return {shift.x(), shift.y(), theta};
  }

 private:
  int count_ = 0;
  Vector2 origin_A_{0.0, 0.0};
  Vector2 origin_B_{0.0, 0.0};
  Vector2 sum_a_{0.0, 0.0};
  Vector2 sum_b_{0.0, 0.0};
  double dot_ = 0.0;
  double cross_ = 0.0;
  double squares_b_ = 0.0;
};

}  // namespace bw
