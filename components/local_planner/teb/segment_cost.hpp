// Residuals of one segment of the band: time, kinematics, speed and acceleration (book 6.1), with analytic
// Jacobians. Plain C++ shared by the solver, the tests and the oracle.
#pragma once

#include <cstddef>

#include "components/local_planner/teb/band_options.hpp"
#include "components/model/limits.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::teb {

/// Square roots of weights and the limits, fixed during one solve. Two readings of motion:
/// - consistent_motion: v = d . dir(mean heading) / dt, held at the middle of its segment, so that the first
///   and last accelerations act over half an interval. A command read from this profile keeps the limits.
/// - otherwise the public package's: v = |d| / dt with a smoothed sign, and the first and last accelerations
///   act over a whole interval.
struct SegmentModel {
  SegmentModel(const BandOptions& options, const Limits& limits);

  Limits limits;
  double epsilon;
  bool consistent_motion;
  double time, kinematics_nh, forward_drive, max_vel_x, max_vel_theta, acc_lim_x, acc_lim_theta;
};

/// What follows the segment: another one, rest at the goal, or nothing that its speed would have to match.
enum class SegmentEnd { next_segment, rest, free };

/// Poses a, b, c = (x, y, theta, dt) of segment a-b and of the next one b-c (c is read only for
/// `next_segment`). `start_twist`: body velocity at a, for the first segment of the band; else null.
struct SegmentStates {
  const double* a;
  const double* b;
  const double* c;
  SegmentEnd end;
  const Twist2* start_twist;
};

inline constexpr std::size_t kSegmentResiduals =
    9;  ///< time, non-holonomic, forward, v, omega, a, alpha, first a, first alpha
inline constexpr std::size_t kSegmentColumns = 12;  ///< d / d (a, b, c)

/// residuals: kSegmentResiduals values. jacobian: row-major kSegmentResiduals x kSegmentColumns, or null.
/// False, and nothing is written, when an interval is too short to divide by.
bool evaluate_segment(const SegmentModel& model, const SegmentStates& states, double* residuals,
                      double* jacobian);

}  // namespace bw::teb
