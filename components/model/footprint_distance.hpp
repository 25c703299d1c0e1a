// How far the footprint of a robot is from an obstacle, and how that changes as the robot moves. Exact for
// discs and polygons.
#pragma once

#include <limits>

#include "components/model/footprint.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// All points within `radius` [m] of the segment a-b: a point or disc has a == b.
struct Capsule {
  Vector2 a{0.0, 0.0};
  Vector2 b{0.0, 0.0};
  double radius = 0.0;
};

/// Signed distance [m] and its derivatives by the pose of the robot.
struct FootprintDistance {
  double distance = 0.0;       ///< negative: how far the robot must move to be free
  Vector2 gradient{0.0, 0.0};  ///< by x and y: away from the obstacle; zero where no direction is better
  double by_theta = 0.0;       ///< by theta [m/rad]; 0 for a disc
};

/// From the footprint at `pose` to the capsule, both in one frame. Of a polygon that is not convex distances
/// outside are exact; how deep a segment crosses it is not.
FootprintDistance distance_to(const Footprint& footprint, const Pose2& pose, const Capsule& capsule);

/// The same without derivatives. From `enough` [m] on any number that is as large will do: the gap of the
/// disc around a polygon, which takes less time.
double gap_to(const Footprint& footprint, const Pose2& pose, const Capsule& capsule,
              double enough = std::numeric_limits<double>::infinity());

/// From a point, a disc of radius zero, to the capsule.
FootprintDistance distance_to(const Vector2& point, const Capsule& capsule);

}  // namespace bw
