// Small judgements of a drive: is it standing, is it there, how far is it still.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "components/navigator/goal_messages.hpp"
#include "components/navigator/navigator_options.hpp"

namespace bw {

inline bool is_standing(const Twist2& twist, const NavigatorOptions& options) {
  return std::abs(twist.v) <= options.kStoppedSpeed && std::abs(twist.omega) <= options.kStoppedTurnRate;
}

inline bool is_within_tolerance(const Pose2& X_MB, const Pose2& X_MG, const NavigatorOptions& options) {
  return (X_MG.position() - X_MB.position()).norm() <= options.xy_tolerance &&
         std::abs(wrap_angle(X_MG.theta - X_MB.theta)) <= options.yaw_tolerance;
}

/// Index of the pose of `path`, which is not empty, nearest to `position` among those before `end`.
inline std::size_t nearest_pose(const std::vector<Pose2>& path, const Vector2& position, std::size_t end) {
  std::size_t nearest = 0;
  for (std::size_t i = 1; i < end; ++i) {
    if ((path[i].position() - position).norm() < (path[nearest].position() - position).norm()) nearest = i;
  }
  return nearest;
}

/// One past the last index of the stretch of `path`, which is not empty, that the robot is on: with poses
/// `via` that are still to be passed it ends at the first of them, however near a later stretch comes.
inline std::size_t stretch_end(const std::vector<Pose2>& path, const std::vector<Pose2>& via) {
  return via.empty() ? path.size() : nearest_pose(path, via.front().position(), path.size()) + 1;
}

/// Length [m] of `path` from the point of its stretch in hand nearest to `position` to its end, plus the
/// distance to that point.
inline double remaining_length(const std::vector<Pose2>& path, const Vector2& position,
                               const std::vector<Pose2>& via = {}) {
  if (path.empty()) return 0.0;
  const std::size_t nearest = nearest_pose(path, position, stretch_end(path, via));
  // Past the nearest point the path goes on to the next one directly.
  const std::size_t from = nearest + 1 < path.size() ? nearest + 1 : nearest;
  double length = (path[from].position() - position).norm();
  for (std::size_t i = from + 1; i < path.size(); ++i) {
    length += (path[i].position() - path[i - 1].position()).norm();
  }
  return length;
}

/// Length [m] of the straight lines from `position` over `via` to the goal.
inline double straight_length(Vector2 position, const std::vector<Pose2>& via, const Pose2& X_MG) {
  double length = 0.0;
  for (const Pose2& X : via) {
    length += (X.position() - position).norm();
    position = X.position();
  }
  return length + (X_MG.position() - position).norm();
}

/// What `distance` takes at the speed of now; as in Nav2 0 for a robot that hardly moves, and for the last
/// decimetre.
inline Duration time_remaining(double distance, const Twist2& twist) {
  constexpr double kSlowest = 0.01;   // [m/s]
  constexpr double kShortest = 0.10;  // [m]
  const double speed = std::abs(twist.v);
  return speed > kSlowest && distance > kShortest ? Duration::seconds(distance / speed) : Duration{};
}

/// How far the robot is beside the path, and how far it is rotated from the path's direction, with Nav2's
/// signs.
struct TrackingError {
  double position = 0.0;  ///< left of it is positive [m]
  double heading = 0.0;   ///< rotated to the right of it is positive [rad]
};

/// Of a robot at `X_MB` on the stretch in hand of a path that is not empty; a path of one pose has that
/// pose's direction.
inline TrackingError tracking_error(const std::vector<Pose2>& path, const Pose2& X_MB,
                                    const std::vector<Pose2>& via = {}) {
  const std::size_t nearest = nearest_pose(path, X_MB.position(), stretch_end(path, via));
  const std::size_t from = nearest + 1 < path.size() || nearest == 0 ? nearest : nearest - 1;
  Vector2 along = direction(path[from].theta);
  if (from + 1 < path.size()) along = path[from + 1].position() - path[from].position();
  if (along.norm() < 1e-9) along = direction(path[from].theta);
  along.normalize();
  return {cross(along, X_MB.position() - path[from].position()),
          wrap_angle(std::atan2(along.y(), along.x()) - X_MB.theta)};
}

}  // namespace bw
