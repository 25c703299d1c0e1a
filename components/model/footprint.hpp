// The outline of the robot seen from above, in base_link.
#pragma once

#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

/// A disc of `radius` [m] around base_link; when `polygon` has three corners or more, that polygon (convex,
/// base_link) is the exact outline and `radius` encloses it.
struct Footprint {
  double radius = 0.3;
  std::vector<Vector2> polygon;

  bool is_polygon() const { return polygon.size() >= 3; }
};

/// Radius [m] of the largest disc around base_link that the footprint holds; 0 where it does not hold
/// base_link.
double inscribed_radius(const Footprint& footprint);

}  // namespace bw
