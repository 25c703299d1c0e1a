// Prediction: wheel steps with the gyro's opinion of their rotation, and time without wheels.
//
// The rotation of the step and the state are estimated together: with the joint covariance diag(P, Q) of the
// state and (distance, rotation), the gyro measures rotation + bias T, and the corrected step then moves the
// state exactly.
#pragma once

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/ekf/ekf_state.hpp"

namespace bw::localization {

/// Adds a reading to the integral since the last wheel step (trapezoids; gaps stay uncovered).
void add_gyro(EkfState& state, const GyroReading& reading, const EkfOptions& options);

/// Predicts to step.time. A step that began before state.time (the filter went on without it) or after it
/// (one was lost) is taken as the part or multiple that fits, if within motion.extrapolation; a longer gap
/// is unknown motion. False when the step ends before state.time: nothing is done.
bool predict(EkfState& state, const WheelStep& step, const EkfOptions& options);

/// Predicts to `time` without wheels: the pose stays, its variance grows as (sigma_v tau)^2 with the time tau
/// since the last wheel step; a gyro still turns the heading.
void predict_without_wheels(EkfState& state, Time time, const EkfOptions& options);

/// The pose at `time` >= state.time by the last twist, its derivative by the state's pose, and the variance
/// that acceleration adds to (position per axis, heading).
struct Extrapolated {
  Pose2 X_MB;
  Eigen::Matrix3d by_pose;
  double position_variance = 0.0;
  double heading_variance = 0.0;
};
Extrapolated extrapolate(const EkfState& state, Time time, const MotionOptions& options);

}  // namespace bw::localization
