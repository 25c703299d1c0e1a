// Three small judgements of a drive: is it standing, is it there, is it getting anywhere.
#pragma once

#include <cmath>
#include <optional>

#include "components/navigator/goal_messages.hpp"
#include "components/navigator/navigator_options.hpp"

namespace bw {

inline bool is_standing(const Twist2& twist, const NavigatorOptions& options) {
  return std::abs(twist.v) <= options.stopped_speed && std::abs(twist.omega) <= options.stopped_turn_rate;
}

inline bool is_within_tolerance(const Pose2& X_MB, const Pose2& X_MG, const NavigatorOptions& options) {
  return (X_MG.position() - X_MB.position()).norm() <= options.xy_tolerance &&
         std::abs(wrap_angle(X_MG.theta - X_MB.theta)) <= options.yaw_tolerance;
}

/// Progress is having moved or turned by the required amount within movement_time.
class ProgressChecker {
 public:
  void reset() { anchor_.reset(); }

  /// False when the last progress is longer ago than movement_time.
  bool update(Time now, const Pose2& X_MB, const NavigatorOptions& options) {
    if (!anchor_ || (X_MB.position() - anchor_->X_MB.position()).norm() >= options.required_movement ||
        std::abs(wrap_angle(X_MB.theta - anchor_->X_MB.theta)) >= options.required_turn) {
      anchor_ = Anchor{now, X_MB};
    }
    return (now - anchor_->time).to_seconds() <= options.movement_time;
  }

 private:
  struct Anchor {
    Time time;
    Pose2 X_MB;
  };
  std::optional<Anchor> anchor_;
};

/// Length [m] of `path` from its point nearest to `position` to its end, plus the way to that point.
inline double remaining_length(const std::vector<Pose2>& path, const Vector2& position) {
  if (path.empty()) return 0.0;
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    if ((path[i].position() - position).norm() < (path[nearest].position() - position).norm()) nearest = i;
  }
  // Past the nearest point the way goes on to the next one directly.
  const std::size_t from = nearest + 1 < path.size() ? nearest + 1 : nearest;
  double length = (path[from].position() - position).norm();
  for (std::size_t i = from + 1; i < path.size(); ++i) {
    length += (path[i].position() - path[i - 1].position()).norm();
  }
  return length;
}

}  // namespace bw
