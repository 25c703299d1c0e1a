// Nearest points of shapes. One frame, metres.
#pragma once

#include <algorithm>

#include "components/model/obstacles.hpp"

namespace bw {

/// Of zero length it is a point.
inline Vector2 nearest_point(const Segment& segment, const Vector2& point) {
  const Vector2 edge = segment.b - segment.a;
  const double length_squared = edge.squaredNorm();
  if (length_squared == 0.0) return segment.a;
  return segment.a + std::clamp((point - segment.a).dot(edge) / length_squared, 0.0, 1.0) * edge;
}

/// On the rim from outside; the point itself from inside.
inline Vector2 nearest_point(const Disc& disc, const Vector2& point) {
  const Vector2 offset = point - disc.center;
  const double distance = offset.norm();
  return distance <= disc.radius ? point : Vector2(disc.center + offset * (disc.radius / distance));
}

}  // namespace bw
