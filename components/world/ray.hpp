// Where a ray first meets a segment or a disc. One frame, metres.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/obstacles.hpp"

namespace bw {

inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// Distance [m] along the ray origin + t * unit_direction (t >= 0) to the segment; kNoHit when it passes by.
inline double ray_hit(const Vector2& origin, const Vector2& unit_direction, const Segment& segment) {
  // Rays through the shared corner of two walls must not slip between them by rounding.
  constexpr double kCorner = 1e-12;
  const Vector2 to_a = segment.a - origin;
  const Vector2 edge = segment.b - segment.a;
  const double denominator = cross(unit_direction, edge);
  if (denominator == 0.0) {
    if (cross(to_a, unit_direction) != 0.0) return kNoHit;
    const double t_a = to_a.dot(unit_direction);
    const double t_b = (segment.b - origin).dot(unit_direction);
    if (std::max(t_a, t_b) < 0.0) return kNoHit;
    return std::max(0.0, std::min(t_a, t_b));
  }
  const double along_edge = cross(to_a, unit_direction) / denominator;
  const double t = cross(to_a, edge) / denominator;
  return along_edge >= -kCorner && along_edge <= 1.0 + kCorner && t >= 0.0 ? t : kNoHit;
}

/// The same for a disc; 0 from inside.
inline double ray_hit(const Vector2& origin, const Vector2& unit_direction, const Disc& disc) {
  const Vector2 to_center = disc.center - origin;
  const double distance_squared = to_center.squaredNorm();
  const double radius_squared = disc.radius * disc.radius;
  if (distance_squared <= radius_squared) return 0.0;
  const double along = to_center.dot(unit_direction);
  const double half_chord_squared = radius_squared - (distance_squared - along * along);
  if (along < 0.0 || half_chord_squared < 0.0) return kNoHit;
  return along - std::sqrt(half_chord_squared);
}

}  // namespace bw
