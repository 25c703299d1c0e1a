// Messages of a bag as entries of a drive; nothing for a message that says nothing of use.
#pragma once

#include <optional>
#include <vector>

#include <bandwagon_msgs/msg/anchor_range.hpp>
#include <geometry_msgs/msg/pose.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/recordings/recorded_drive.hpp"

namespace bw {

std::optional<OdometrySample> to_sample(const nav_msgs::msg::Odometry& message, Time time);
/// Heading and turn rate, unless the message marks them as not measured (REP 145) or they are no numbers.
std::optional<ImuSample> to_sample(const sensor_msgs::msg::Imu& message, Time time);
/// Nothing without a fix.
std::optional<FixSample> to_sample(const sensor_msgs::msg::NavSatFix& message, Time time);
std::optional<RangeSample> to_sample(const bandwagon_msgs::msg::AnchorRange& message, Time time);
std::optional<ScanSample> to_sample(const sensor_msgs::msg::LaserScan& message, Time time);
/// An orientation that is none gives no heading.
std::optional<ReferencePose> to_reference(const geometry_msgs::msg::Pose& pose, Time time);
std::vector<FrameMount> to_mounts(const tf2_msgs::msg::TFMessage& message);

}  // namespace bw
