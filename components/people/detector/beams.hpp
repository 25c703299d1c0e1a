// What each beam of a sweep says, in O (odom).
#pragma once

#include <vector>

#include "components/model/laser_sweep.hpp"

namespace bw::people {

/// Beside fault_of: beams closer than 0.2 rad (wider apart they show no leg beyond half a metre), one of
/// which says anything.
SweepFault fault_for_people(const LaserSweep& sweep);

/// The beams by rising angle, whichever way the scanner rotates.
struct Beams {
  double angle_min = 0.0;  ///< in O [rad]
  double angle_increment = 0.0;
  double time_increment = 0.0;  ///< from one beam to the next [s]
  bool closed = false;          ///< the last beam is the first one's neighbour
  Vector2 sensor{0.0, 0.0};
  std::vector<BeamKind> kinds;
  std::vector<float> ranges;    ///< of a hit; range_max of a free beam; 0 of an unknown one [m]
  std::vector<Vector2> points;  ///< where a hit is, in O

  int size() const { return static_cast<int>(kinds.size()); }
  /// When beam i was taken, from the middle one on [s].
  double taken_after(int i) const { return time_increment * (i - 0.5 * size()); }
  /// Neighbour of beam i, or -1 past an end.
  int next(int i) const { return i + 1 < size() ? i + 1 : closed ? 0 : -1; }
  int previous(int i) const { return i > 0 ? i - 1 : closed ? size() - 1 : -1; }
};

/// Fills `beams`, keeping its memory. The sweep must be without fault, its scanner in O.
void read_beams(const LaserSweep& sweep, Beams& beams);

}  // namespace bw::people
