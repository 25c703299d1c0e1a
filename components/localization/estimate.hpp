// What a filter answers: what became of a measurement, and where the robot is.
#pragma once

#include <Eigen/Core>

#include "components/localization/verdict.hpp"
#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw::localization {

struct Outcome {
  Verdict verdict = Verdict::accepted;
  double nis = 0.0;  ///< 0 for motion
  int dof = 0;       ///< 0 for motion
  int replayed = 0;  ///< measurements computed again because this one was late
  bool clock_jumped = false;
};

struct Estimate {
  Time time;
  Pose2 X_MB;
  Twist2 twist;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of (x, y, theta)
  double gyro_bias = 0.0;                                ///< [rad/s]
  double heading_offset = 0.0;                           ///< what the compass reads too much [rad]
};

/// Semi-axes [m] of the ellipse that holds the position with 95 %: sqrt(5.991 eigenvalues), larger first.
Vector2 ellipse_95(const Eigen::Matrix2d& P);

}  // namespace bw::localization
