// What the world's sensors and truth look like as ROS 2 messages. Pure conversions.
#pragma once

#include <string>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/wheel_ticks.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>

#include "components/world/world.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// `message` keeps its buffers from scan to scan; its constant fields are set every time.
void to_message(const LaserScan& scan, const LaserOptions& options, Time stamp,
                sensor_msgs::msg::LaserScan& message);

/// Roll and pitch are zero on a flat floor; accelerations are marked as not measured.
sensor_msgs::msg::Imu to_message(const ImuReading& reading, const ImuOptions& options, Time stamp);

/// Stamped with the time of the measurement. The altitude is not known: NaN.
sensor_msgs::msg::NavSatFix to_message(const GpsFix& fix, const GpsOptions& options, Time world_start);

bandwagon_msgs::msg::WheelTicks to_message(const EncoderTicks& ticks, Time stamp);

/// Frame: map. Wall clearance from the robot's rim, infinite where no wall is near; the other robots are
/// among the people.
bandwagon_msgs::msg::GroundTruth ground_truth(const World& world, std::size_t robot, Time stamp);

}  // namespace bw
