// From what sensors publish to measurements. For the adaptor only. Where a message gives no variance (zeros,
// or the mark of its type for 'unknown'), the sigma handed in counts. Numbers are passed on as they are:
// filters check them. `source` is the number that the filter knows the sensor by.
#pragma once

#include <optional>

#include <bandwagon_msgs/msg/anchor_range.hpp>
#include <geometry_msgs/msg/pose_with_covariance_stamped.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>

#include "components/localization/measurements.hpp"
#include "components/model/local_plane.hpp"

namespace bw::localization {

/// X_BS: pose of the sensor in base_link. Nothing where the message says that it does not measure this (REP
/// 145).
std::optional<GyroReading> to_gyro(const sensor_msgs::msg::Imu& message, int source, double sigma);
std::optional<HeadingReading> to_heading(const sensor_msgs::msg::Imu& message, int source, const Pose2& X_BS,
                                         double sigma);

/// Nothing without a fix, or when its position is none on the earth. An unknown altitude counts as that of
/// the datum.
std::optional<Geodetic> to_geodetic(const sensor_msgs::msg::NavSatFix& message, double unknown_altitude);
PositionFix to_fix(const sensor_msgs::msg::NavSatFix& message, int source, const Geodetic& geodetic,
                   const LocalPlane& plane, const Pose2& X_BS, double sigma);

/// A pose; or a position only, when the variance of its yaw says that it is unknown (above 10 rad^2).
Measurement to_measurement(const geometry_msgs::msg::PoseWithCovarianceStamped& message, int source);

RangeReading to_range(const bandwagon_msgs::msg::AnchorRange& message, int source);

}  // namespace bw::localization
