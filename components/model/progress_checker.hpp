// Whether a drive is getting anywhere: has the robot moved, or rotated, far enough for the time that has
// passed?
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct ProgressLimits {
  double movement = 0.5;  ///< so far is progress [m]
  double rotation =
      std::numeric_limits<double>::infinity();  ///< so is a rotation by this [rad]; infinity: no rotation is
  double time = 10.0;                           ///< longest without progress [s]
};

/// Poses of one call to the next are in the same frame.
class ProgressChecker {
 public:
  void reset() { anchor_.reset(); }

  /// False when the last progress is longer ago than `limits` allow. A first call, and one of an earlier time
  /// than the last progress, is a start.
  bool update(Time now, const Pose2& X, const ProgressLimits& limits) {
    if (!anchor_ || now < anchor_->time || (X.position() - anchor_->X.position()).norm() >= limits.movement ||
        std::abs(wrap_angle(X.theta - anchor_->X.theta)) >= limits.rotation) {
      anchor_ = Anchor{now, X};
    }
    return (now - anchor_->time).to_seconds() <= limits.time;
  }

 private:
  struct Anchor {
    Time time;
    Pose2 X;
  };
  std::optional<Anchor> anchor_;
};

}  // namespace bw
