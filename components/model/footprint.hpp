// The outline of the robot seen from above, in base_link.
#pragma once

#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

/// A disc of `radius` [m] around base_link; when `polygon` is not empty, that polygon (counter-clockwise,
/// base_link) is the exact outline and `radius` encloses it.
struct Footprint {
  double radius = 0.3;
  std::vector<Vector2> polygon;
};

}  // namespace bw
