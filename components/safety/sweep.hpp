// One sweep of a laser, judged beam by beam before anybody relies on it.
#pragma once

#include <vector>

#include "components/model/laser_sweep.hpp"
#include "components/safety/sweep_options.hpp"

namespace bw::safety {

/// Something the laser saw, in base_link.
struct SeenPoint {
  Vector2 position{0.0, 0.0};  ///< [m]
  bool is_narrow = false;      ///< of a thing that stands alone and is no wider than legs
};

struct CheckedSweep {
  SweepFault fault = SweepFault::none;
  double angle_min = 0.0;        ///< of the first beam in base_link [rad]
  double angle_increment = 0.0;  ///< [rad]
  Vector2 laser{0.0, 0.0};       ///< where it sits in base_link [m]
  std::vector<BeamKind> beams;
  std::vector<bool> dark;         ///< free beams that are not to be believed (empty_sight.hpp); empty: none
  std::vector<SeenPoint> points;  ///< hits that enough neighbouring beams confirm
};

/// The laser in base_link. Beams and points are empty when there is a fault.
CheckedSweep check_sweep(const LaserSweep& sweep, const SweepOptions& options);

/// How much of a sector of directions the laser sees.
struct Sight {
  double covered = 0.0;     ///< share of the sector the laser looks at, 0 to 1
  double unknown = 0.0;     ///< share of the beams there that are unknown or dark, 0 to 1
  double dark = 0.0;        ///< share of the beams there that are dark, 0 to 1
  double widest_gap = 0.0;  ///< widest run of directions there of which no beam says anything [rad]
};

/// Sector of `half_angle` [rad] to either side of `bearing` [rad, base_link]. The laser's position on the
/// robot is neglected.
Sight sight_of(const CheckedSweep& sweep, double bearing, double half_angle);

/// Whether a beam towards `position` (base_link of the sweep), or one beside it, says anything.
bool sees(const CheckedSweep& sweep, const Vector2& position);

}  // namespace bw::safety
