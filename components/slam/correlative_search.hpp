// A pose found by trying a whole window: correlative matching (Olson 2009) against a submap's likelihood.
#pragma once

#include <span>

#include "components/slam/surface_map.hpp"

namespace bw::slam {

/// Half sizes of a box of poses about a start.
struct SearchWindow {
  double x = 0.1;      ///< [m], in the submap's axes
  double y = 0.1;      ///< [m]
  double theta = 0.1;  ///< [rad]
};

struct Correlation {
  Pose2 X;             ///< the best
  double score = 0.0;  ///< mean likelihood of the points, 0 to 1
};

/// In steps of a cell, and of the angle that moves the farther points by one: every third pose of the window,
/// then all around the best of them. Poses nearer to the start come before others that fit nearly as well
/// (theory.md 10.4).
Correlation correlate(const SurfaceMap& map, std::span<const SurfacePoint> points, const Pose2& start,
                      const SearchWindow& window);

}  // namespace bw::slam
