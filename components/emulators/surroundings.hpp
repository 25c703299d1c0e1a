// What a base touches and what its beams hit, in the simulated world. Frame: map.
#pragma once

#include <vector>

#include "components/emulators/emulated_base.hpp"
#include "components/world/static_scene.hpp"

namespace bw::emulators {

/// Bumpers that something within `gap` [m] of the robot's rim presses: ahead the centre, up to 100 degrees
/// aside left or right; what is near both presses both.
ContactReading touched(const Pose2& X_map_base, double radius, double gap, const StaticScene& scene,
                       const std::vector<Disc>& people);

/// Nearest thing in the beam [m]; infinite: nothing within its reach.
double range_of(const Beam& beam, const Pose2& X_map_base, const StaticScene& scene,
                const std::vector<Disc>& people);

}  // namespace bw::emulators
