// map -> odom as it is told: a step of it disturbs whoever drives by it, so that a correction is fed in over time.
#pragma once

#include <algorithm>
#include <cmath>

#include "runtime/base/pose2.hpp"

namespace bw::slam {

class MapToOdom {
 public:
  static constexpr double kMostTravel =
      0.015;  ///< [m] the robot moves in the map by one transform's correction
  static constexpr double kMostTurn = 0.007;  ///< [rad]

  explicit MapToOdom(const Pose2& X_MO = {}) : told_(X_MO), wanted_(X_MO) {}

  void set(const Pose2& X_MO) { wanted_ = X_MO; }
  /// At once: nobody has driven by it yet, or the pose was given.
  void jump(const Pose2& X_MO) { told_ = wanted_ = X_MO; }

  /// X_MO for a transform more, with the robot at X_OB: there the correction is measured.
  Pose2 next(const Pose2& X_OB) {
    const Pose2 at = told_ * X_OB;
    const Pose2 to = wanted_ * X_OB;
    const double travel = std::hypot(to.x - at.x, to.y - at.y);
    const double turn = std::abs(wrap_angle(to.theta - at.theta));
    const double share =
        std::min({1.0, kMostTravel / std::max(travel, 1e-9), kMostTurn / std::max(turn, 1e-9)});
    const Pose2 X_MB{at.x + share * (to.x - at.x), at.y + share * (to.y - at.y),
                     wrap_angle(at.theta + share * wrap_angle(to.theta - at.theta))};
    told_ = share >= 1.0 ? wanted_ : X_MB * inverse(X_OB);
    return told_;
  }
  const Pose2& told() const { return told_; }

 private:
  Pose2 told_;
  Pose2 wanted_;
};

}  // namespace bw::slam
