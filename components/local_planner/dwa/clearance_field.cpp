#include "components/local_planner/dwa/clearance_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/mover_weight.hpp"

namespace bw::dwa {
namespace {

double distance(const Vector2& p, const Segment& s) {
  const Vector2 d = s.b - s.a;
  const double share = std::clamp((p - s.a).dot(d) / std::max(d.squaredNorm(), 1e-18), 0.0, 1.0);
  return (p - s.a - share * d).norm();
}

}  // namespace

ClearanceField::ClearanceField(const StaticObstacles& obstacles, const std::vector<Mover>& movers,
                               const Vector2& center, double robot_radius, double reach)
    : robot_radius_(robot_radius) {
  std::vector<Disc> discs;
  const auto add = [&](const Vector2& p, double radius) {
    if ((p - center).norm() - radius - robot_radius < reach) discs.push_back({p, radius + robot_radius});
  };
  for (const Vector2& p : obstacles.points) add(p, 0.0);
  for (const Disc& d : obstacles.discs) add(d.center, d.radius);
  for (const Mover& m : movers) {
    if (is_confirmed(m)) add(m.position, m.radius);
  }
  for (const Segment& s : obstacles.segments) {
    if (distance(center, s) - robot_radius < reach) segments_.push_back(s);
  }
  const auto count = static_cast<Eigen::Index>(discs.size());
  x_.resize(count);
  y_.resize(count);
  radius_.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Disc& d = discs[static_cast<std::size_t>(i)];
    x_[i] = d.center.x();
    y_[i] = d.center.y();
    radius_[i] = d.radius;
  }
}

double ClearanceField::at(const Vector2& p) const {
  double gap = std::numeric_limits<double>::infinity();
  if (x_.size() > 0) gap = (((x_ - p.x()).square() + (y_ - p.y()).square()).sqrt() - radius_).minCoeff();
  for (const Segment& s : segments_) gap = std::min(gap, distance(p, s) - robot_radius_);
  return gap;
}

}  // namespace bw::dwa
