// The velocity nearest to a wish outside all cones: exact candidates as in ClearPath (Guy et al. 2009).
#pragma once

#include <optional>
#include <vector>

#include "components/model/planning.hpp"

namespace bw::hrvo {

struct BestVelocity {
  Vector2 velocity{0.0, 0.0};  ///< [m/s], at most v_max
  bool free = true;            ///< outside all cones
};

/// Where to go if it costs little.
struct PreviousVelocity {
  Vector2 velocity{0.0, 0.0};  ///< [m/s] of the last decision
  double allowance = 0.0;      ///< [m/s] that a velocity nearer to it may be further from the wish
};

/// `cones` nearest neighbour first. Of velocities equally near to `preferred` (within the allowance) the one
/// nearest to the favoured one; of equal ones the one to the right. When no candidate is free: the one whose
/// first violated cone comes last (the contact it leads to is with the farthest neighbour), then the nearest
/// to `preferred`.
BestVelocity best_velocity(const std::vector<VelocityCone>& cones, const Vector2& preferred, double v_max,
                           const std::optional<PreviousVelocity>& favour = {});

}  // namespace bw::hrvo
