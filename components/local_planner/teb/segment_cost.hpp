// Residuals of one segment of the band: time, kinematics, speed and acceleration (theory.md 6.1), with
// analytic Jacobians. Plain C++ shared by both solvers and the tests.
#pragma once

#include <array>
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

/// A pose (x, y, theta, dt) with the direction of its heading, which takes longest: once per pose.
struct Heading {
  explicit Heading(const double* pose_in) : pose(pose_in), u(direction(pose_in[2])) {}

  const double* pose;
  Vector2 u;
};

/// Speed and turn rate of the segment from pose a to pose b, each by x, y, theta, dt of a and x, y, theta of
/// b. False, and nothing is written, when the interval is too short to divide by.
struct SegmentMotion {
  static constexpr std::size_t kInputs = 7;
  struct Quantity {
    double value;
    std::array<double, kInputs> gradient;
  };

  double dt;  // [s]
  Quantity v, omega;
};
bool evaluate_motion(const SegmentModel& model, const Heading& a, const Heading& b, SegmentMotion& motion);

/// Segment a-b with its motion and that of the next one (read only for `next_segment`). `start_twist`: body
/// velocity at a, for the first segment of the band; else null.
struct SegmentStates {
  const Heading& a;
  const Heading& b;
  const SegmentMotion& motion;
  const SegmentMotion* next;
  SegmentEnd end;
  const Twist2* start_twist;
};

inline constexpr std::size_t kSegmentResiduals =
    9;  ///< time, non-holonomic, forward, v, omega, a, alpha, first a, first alpha
inline constexpr std::size_t kSegmentColumns = 12;  ///< d / d (a, b, c), c the end of the next segment

/// Residuals and, of those that vary here (the penalties that act), rows of the Jacobian: `active` of them,
/// row i of residual `of_row[i]`.
struct SegmentRows {
  std::array<double, kSegmentResiduals> residuals;
  std::size_t active;
  std::array<std::size_t, kSegmentResiduals> of_row;
  std::array<std::array<double, kSegmentColumns>, kSegmentResiduals> jacobian;
};
void evaluate_segment(const SegmentModel& model, const SegmentStates& states, SegmentRows& rows);

/// The sum of the squared residuals alone.
double segment_cost(const SegmentModel& model, const SegmentStates& states);

}  // namespace bw::teb
