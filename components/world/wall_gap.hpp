// How far a robot's rim is from what never moves. Frame: map.
#pragma once

#include "components/model/footprint.hpp"
#include "components/world/static_scene.hpp"

namespace bw {

/// From the footprint at `pose` to the nearest static thing, at most `limit` [m]; negative: it is in one.
/// Exact from outside.
double wall_gap(const StaticScene& scene, const Footprint& footprint, const Pose2& pose, double limit);

}  // namespace bw
