#include "components/safety/zone.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "components/model/differential_drive.hpp"

namespace bw::safety {

Zone::Zone(const ZoneOptions& options) : options_(options) {
  for (const CornerOptions& corner : options.points) corners_.emplace_back(corner.x, corner.y);
}

bool Zone::contains(const Vector2& p) const {
  if (options_.type == ZoneShape::circle) return p.squaredNorm() <= options_.radius * options_.radius;
  bool inside = false;  // crossings of the ray from p towards +x with the edges
  for (std::size_t i = 0, j = corners_.size() - 1; i < corners_.size(); j = i++) {
    const Vector2& a = corners_[i];
    const Vector2& b = corners_[j];
    const bool crosses = (a.y() > p.y()) != (b.y() > p.y()) &&
                         p.x() < a.x() + (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y());
    inside = inside != crosses;
  }
  return inside;
}

bool Zone::triggered(const std::vector<SeenPoint>& points, const Pose2& X_BN) const {
  const Pose2 X_NB = inverse(X_BN);
  std::int64_t count = 0;
  for (const SeenPoint& point : points) {
    if (contains(X_NB * point.position) && ++count >= options_.min_points) return true;
  }
  return false;
}

double Zone::stop_share(const Twist2& wanted, const std::vector<SeenPoint>& points) const {
  if (!triggered(points, {})) return 1.0;
  const bool approaches = std::any_of(points.begin(), points.end(), [&](const SeenPoint& point) {
    return contains(point.position) && !leads_out(wanted, point.position);
  });
  return approaches ? 0.0 : 1.0;
}

/// A rotation moves `p`, seen from the robot, around it: out of the zone or not; around a circle, never.
bool Zone::leads_out(const Twist2& wanted, const Vector2& p) const {
  if (wanted.v * p.x() > 0.0) return false;
  if (std::abs(wanted.v) >= std::abs(wanted.omega) * p.norm()) return true;
  if (options_.type == ZoneShape::circle) return false;
  const Vector2 rotated(wanted.omega * p.y(), -wanted.omega * p.x());
  double nearest = std::numeric_limits<double>::infinity();
  bool is_outward = false;
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    const Vector2 side = corners_[(i + 1) % corners_.size()] - corners_[i];
    const double share = std::clamp(side.dot(p - corners_[i]) / side.squaredNorm(), 0.0, 1.0);
    const Vector2 out = corners_[i] + share * side - p;
    if (out.norm() >= nearest) continue;
    nearest = out.norm();
    is_outward = out.dot(rotated) > 0.0;
  }
  return is_outward;
}

double Zone::approach_share(const Twist2& wanted, const std::vector<SeenPoint>& points) const {
  if (wanted.v == 0.0 || triggered(points, {})) return stop_share(wanted, points);
  const double step = options_.simulation_time_step;
  const int steps = static_cast<int>(std::ceil(options_.time_before_collision / step));
  Pose2 X_BN;
  for (int i = 1; i <= steps; ++i) {
    X_BN = advance_exact(X_BN, wanted, step);
    if (triggered(points, X_BN)) return (i - 1) * step / options_.time_before_collision;
  }
  return 1.0;
}

double Zone::share_left(const Twist2& wanted, const std::vector<SeenPoint>& points) const {
  if (options_.action_type == Action::stop) return stop_share(wanted, points);
  if (options_.action_type == Action::approach) return approach_share(wanted, points);
  if (!triggered(points, {})) return 1.0;
  if (options_.action_type == Action::slowdown) return options_.slowdown_ratio;
  double share = 1.0;
  if (std::abs(wanted.v) > options_.linear_limit) share = options_.linear_limit / std::abs(wanted.v);
  if (std::abs(wanted.omega) > options_.angular_limit)
    share = std::min(share, options_.angular_limit / std::abs(wanted.omega));
  return share;
}

}  // namespace bw::safety
