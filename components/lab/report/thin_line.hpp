// Many points, as a line or as dots, drawn with few.
#pragma once

#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

/// Some of `points`, the first and the last among them, so that no other is farther than `tolerance` from the
/// line through those kept (Douglas and Peucker). Points that are not finite are left out.
std::vector<Vector2> thin_line(const std::vector<Vector2>& points, double tolerance);

/// The first point, and each that is at least `apart` from the last one kept. Points that are not finite are
/// left out.
std::vector<Vector2> thin_dots(const std::vector<Vector2>& points, double apart);

}  // namespace bw
