// How far a robot's rim is from somebody who is a disc.
#pragma once

#include <cmath>

#include "components/model/footprint_distance.hpp"

namespace bw {

/// From the footprint at `pose` to a disc [m]; negative: they overlap. A polygon without a heading is taken
/// for the disc around it.
inline double rim_gap(const Footprint& footprint, const Pose2& pose, const Vector2& center, double radius) {
  if (footprint.is_polygon() && std::isfinite(pose.theta))
    return gap_to(footprint, pose, {center, center, radius});
  return (center - pose.position()).norm() - radius - footprint.radius;
}

}  // namespace bw
