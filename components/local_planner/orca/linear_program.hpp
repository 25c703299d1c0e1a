// The velocity within all half planes that is nearest to a wish, or the least bad one: linear programs in the
// plane (theory.md 5.6; van den Berg, Guy, Lin, Manocha 2011, section 5; de Berg et al. 2008, chapter 4).
#pragma once

#include <cstddef>
#include <vector>

#include "components/local_planner/orca/half_plane.hpp"

namespace bw::orca {

struct Choice {
  Vector2 velocity{0.0, 0.0};  ///< [m/s], at most v_max
  bool free = true;            ///< within all half planes
};

/// Of the velocities of at most `v_max` [m/s]: the nearest to `wanted` within all half planes. When there is
/// none: within the first `walls` of them, the one whose greatest violation of the others is smallest. The
/// first ones must have a velocity in common.
/// Half planes that differ by less than 1e-5 rad count as parallel.
Choice best_velocity(const std::vector<HalfPlane>& half_planes, std::size_t walls, const Vector2& wanted,
                     double v_max);

}  // namespace bw::orca
