// One sweep of a laser scanner: what each beam says, and whether the whole is of any use.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// A view of somebody else's ranges, which must live as long as the call. Beam i looks at angle_min + i *
/// angle_increment in the scanner's frame L.
struct LaserSweep {
  Time time;
  Pose2 X_FL;                     ///< scanner in the frame F its reader works in: base_link or odom
  double angle_min = 0.0;         ///< [rad]
  double angle_increment = 0.0;   ///< [rad], of either sign
  double range_min = 0.0;         ///< [m]
  double range_max = 0.0;         ///< [m]
  std::span<const float> ranges;  ///< [m]
  std::optional<double> angle_max = std::nullopt;  ///< of the last beam, if the source says so [rad]
  /// X_FL of each beam, if the scanner moved meanwhile (sweep_motion.hpp); empty: X_FL is that of all. Views,
  /// as the ranges are.
  std::span<const Pose2> beam_poses = {};
  /// From one beam to the next [s]; negative when the last beam was taken first. Zero: all at `time`, which
  /// else is the middle's.
  double time_increment = 0.0;
};

/// When beam i was taken, from sweep.time on [s].
inline double taken_after(const LaserSweep& sweep, double beam) {
  return sweep.time_increment * (beam - 0.5 * static_cast<double>(sweep.ranges.size()));
}

/// The scanner when it took beam i, in F.
inline const Pose2& scanner_at(const LaserSweep& sweep, std::size_t beam) {
  return sweep.beam_poses.empty() ? sweep.X_FL : sweep.beam_poses[beam];
}

/// By REP 117.
enum class BeamKind : std::uint8_t {
  unknown,  ///< says nothing, and is never free: NaN, -inf (too near), zero, negative, out of the limits
  free,     ///< +inf: nothing up to range_max
  hit       ///< above 0, and from range_min to range_max
};
BeamKind kind_of(float range, const LaserSweep& sweep);

/// Why a sweep as a whole is of no use. The last five are for readers who need more than fault_of asks for.
enum class SweepFault {
  none,
  bad_angles,    ///< not finite, or no steps of a scanner
  bad_limits,    ///< range_min to range_max is no interval
  wrong_length,  ///< fewer than two beams, more than go round once, or not as many as angle_max promises
  bad_pose,    ///< X_FL is not finite, or farther away than any robot; or the beams' are, or are not as many
  not_later,   ///< than the sweep before
  no_returns,  ///< nothing is hit where something must be
  mostly_unknown,  ///< too few beams say anything
  unplaced,        ///< nobody says where on the robot its frame is
  bad_stamp,       ///< it is too old, or nobody knows how old (runtime/base/stamp_age.hpp)
};
const char* to_text(SweepFault fault);

/// Of a sweep without fault the number of beams is bounded, and every end of a beam is finite.
SweepFault fault_of(const LaserSweep& sweep);

}  // namespace bw
