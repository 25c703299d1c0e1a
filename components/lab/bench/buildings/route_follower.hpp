// Follows a route: corners are rounded, and where it turns back the robot stops and turns in place. Pure
// pursuit of a point a little ahead (Coulter 1992). Frame: map.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw::buildings {

struct FollowerOptions {
  double speed = 0.5;      ///< [m/s]
  double turn_rate = 1.0;  ///< [rad/s]
};

class RouteFollower {
 public:
  /// Throws std::invalid_argument when the route has fewer than two corners.
  RouteFollower(const std::vector<Vector2>& route, const FollowerOptions& options);

  Pose2 start() const;
  /// What to do from this pose, to be called again a few hundredths of a second later; nothing at the end.
  std::optional<Twist2> next(const Pose2& X_map_base);

 private:
  void add_line(const Vector2& to);
  void round_corner(const Vector2& before, const Vector2& corner, const Vector2& after);
  double heading_of_piece() const;
  Vector2 target() const;

  FollowerOptions options_;
  std::vector<Vector2> path_;           ///< points kSpacing apart or nearer
  std::vector<std::size_t> turnbacks_;  ///< points of the path where it stops, the last one too
  std::size_t piece_ = 0;               ///< it is on its way to this one of them
  std::size_t nearest_ = 0;             ///< point of the path
  bool turns_in_place_ = true;
};

}  // namespace bw::buildings
