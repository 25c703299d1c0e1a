// A first pose from ranges to anchors alone: position, and the heading from the path driven.
#pragma once

#include <optional>

#include <Eigen/Core>

#include "components/recordings/recorded_drive.hpp"

namespace bw {

struct RangeStart {
  Time time;  ///< of the last range used
  Pose2 X_MB;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// The pose of the odometry's frame that fits the ranges best (least squares of Cauchy's loss, which outliers
/// hardly move; Gauss-Newton from a grid of headings), at the earliest range after which the heading is known
/// within `heading_sigma` [rad]. Nothing if that is never the case. The wheels are taken as exact meanwhile.
std::optional<RangeStart> range_start(const RecordedDrive& drive, double heading_sigma);

}  // namespace bw
