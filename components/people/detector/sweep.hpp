// One sweep of a laser scanner, and what each of its beams says, in O (odom).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/model/pose2.hpp"
#include "components/model/time.hpp"

namespace bw::people {

/// A view of somebody else's ranges, which must live as long as the call. Beam i looks at angle_min + i *
/// angle_increment in the scanner's frame L.
struct Sweep {
  Time time;
  Pose2 X_OL;
  double angle_min = 0.0;        ///< [rad]
  double angle_increment = 0.0;  ///< [rad], of either sign
  double range_min = 0.0;        ///< nearer is no reading [m]
  double range_max = 0.0;        ///< farther is no reading; no return is +inf [m]
  std::span<const float> ranges;
};

/// Why a sweep as a whole is of no use.
enum class SweepFault { none, no_beams, too_many_beams, bad_angles, bad_limits, bad_pose, no_reading };
const char* to_text(SweepFault fault);

SweepFault fault_of(const Sweep& sweep);

enum class BeamKind : std::uint8_t {
  unknown,  ///< NaN, zero, negative, -inf or beyond range_max: says nothing
  free,     ///< +inf: nothing up to range_max (REP 117)
  hit
};

/// The beams by rising angle, whichever way the scanner turns.
struct Beams {
  double angle_min = 0.0;  ///< in O [rad]
  double angle_increment = 0.0;
  bool closed = false;  ///< the last beam is the first one's neighbour
  Vector2 sensor{0.0, 0.0};
  std::vector<BeamKind> kinds;
  std::vector<float> ranges;    ///< of a hit; range_max of a free beam; 0 of an unknown one [m]
  std::vector<Vector2> points;  ///< where a hit is, in O

  int size() const { return static_cast<int>(kinds.size()); }
  /// Neighbour of beam i, or -1 past an end.
  int next(int i) const { return i + 1 < size() ? i + 1 : closed ? 0 : -1; }
  int previous(int i) const { return i > 0 ? i - 1 : closed ? size() - 1 : -1; }
};

/// Fills `beams`, keeping its memory. The sweep must be without fault.
void read_beams(const Sweep& sweep, Beams& beams);

}  // namespace bw::people
