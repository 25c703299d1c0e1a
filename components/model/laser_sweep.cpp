#include "components/model/laser_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bw {

BeamKind kind_of(float range, const LaserSweep& sweep) {
  if (range == std::numeric_limits<float>::infinity()) return BeamKind::free;
  return range > 0.0F && range >= sweep.range_min && range <= sweep.range_max ? BeamKind::hit
                                                                              : BeamKind::unknown;
}

const char* to_text(SweepFault fault) {
  switch (fault) {
    case SweepFault::none:
      return "it is sound";
    case SweepFault::bad_angles:
      return "its angles are no steps of a scanner";
    case SweepFault::bad_limits:
      return "its least and largest range are no interval";
    case SweepFault::wrong_length:
      return "its number of beams does not fit its angles";
    case SweepFault::bad_pose:
      return "its place is not finite, or too far away";
    case SweepFault::not_later:
      return "it is not later than the one before";
    case SweepFault::no_returns:
      return "it hits nothing where something was just seen";
    case SweepFault::mostly_unknown:
      return "too few of its beams say anything";
    case SweepFault::unplaced:
      return "nobody says where on the robot its frame is";
    case SweepFault::bad_stamp:
      return "its stamp is too old, or nobody knows how old it is";
  }
  return "unknown";
}

SweepFault fault_of(const LaserSweep& sweep) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  constexpr double kLeastIncrement = 1e-4;  // [rad]: finer than any scanner, and a bound on the beams
  constexpr double kMaxIncrement = 0.5;     // [rad]
  constexpr double kLongestRange = 1e4;     // [m]
  constexpr double kFarthest = 1e6;         // [m]
  const double step = std::abs(sweep.angle_increment);
  if (!(std::abs(sweep.angle_min) <= 2.0 * kTwoPi) || !(step >= kLeastIncrement && step <= kMaxIncrement))
    return SweepFault::bad_angles;
  if (!(sweep.range_min >= 0.0 && sweep.range_max > sweep.range_min && sweep.range_max <= kLongestRange))
    return SweepFault::bad_limits;
  if (sweep.ranges.size() < 2) return SweepFault::wrong_length;
  const double width = static_cast<double>(sweep.ranges.size() - 1) * sweep.angle_increment;
  if (std::abs(width) > kTwoPi + 2.0 * step) return SweepFault::wrong_length;
  // Some drivers name the angle after the last beam.
  if (sweep.angle_max && !(std::abs(sweep.angle_min + width - *sweep.angle_max) < 1.5 * step))
    return SweepFault::wrong_length;
  const auto is_sound = [](const Pose2& X) { return is_finite(X) && X.position().norm() <= kFarthest; };
  if (!is_sound(sweep.X_FL) || !std::ranges::all_of(sweep.beam_poses, is_sound)) return SweepFault::bad_pose;
  if (!sweep.beam_poses.empty() && sweep.beam_poses.size() != sweep.ranges.size())
    return SweepFault::bad_pose;
  return SweepFault::none;
}

}  // namespace bw
