// The velocity nearest to a wish outside all cones: exact candidates as in ClearPath (Guy et al. 2009).
#pragma once

#include <vector>

#include "components/model/planning.hpp"

namespace bw::hrvo {

struct BestVelocity {
  Vector2 velocity{0.0, 0.0};  ///< [m/s], at most v_max
  bool free = true;            ///< outside all cones
};

/// `cones` nearest neighbour first. Of two velocities equally near to `preferred` the one to its right. When
/// no candidate is free: the one whose first violated cone comes last (the contact it leads to is with the
/// farthest neighbour), then the nearest to `preferred`.
BestVelocity best_velocity(const std::vector<VelocityCone>& cones, const Vector2& preferred, double v_max);

}  // namespace bw::hrvo
