// The error ellipse of a position.
#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>

#include "runtime/base/pose2.hpp"

namespace bw {

/// Standard deviations along the principal axes of a covariance of (x, y), the larger first [m]; 0 for what is negative.
inline Vector2 principal_deviations(const Eigen::Matrix2d& P) {
  const double mean = (P(0, 0) + P(1, 1)) / 2.0;
  const double radius = std::hypot((P(0, 0) - P(1, 1)) / 2.0, P(0, 1));
  return {std::sqrt(std::max(0.0, mean + radius)), std::sqrt(std::max(0.0, mean - radius))};
}

}  // namespace bw
