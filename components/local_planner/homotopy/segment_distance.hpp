// Squared distances between points and segments of the plane; zero-length segments are points.
#pragma once

#include <algorithm>

#include "components/model/obstacles.hpp"

namespace bw::homotopy {

inline double squared_distance(const Vector2& point, const Segment& segment) {
  const Vector2 d = segment.b - segment.a;
  const Vector2 to_point = point - segment.a;
  const double length = d.squaredNorm();
  if (length == 0.0) return to_point.squaredNorm();
  const double s = std::clamp(to_point.dot(d) / length, 0.0, 1.0);
  return (to_point - s * d).squaredNorm();
}

/// Zero when they cross.
inline double squared_distance(const Segment& p, const Segment& q) {
  if (q.a == q.b) return squared_distance(q.a, p);
  if (p.a == p.b) return squared_distance(p.a, q);
  const auto side = [](const Segment& s, const Vector2& point) { return cross(s.b - s.a, point - s.a); };
  if (side(p, q.a) * side(p, q.b) < 0.0 && side(q, p.a) * side(q, p.b) < 0.0) return 0.0;
  return std::min({squared_distance(p.a, q), squared_distance(p.b, q), squared_distance(q.a, p),
                   squared_distance(q.b, p)});
}

}  // namespace bw::homotopy
