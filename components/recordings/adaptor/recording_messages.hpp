// Entries of a recorded drive as ROS 2 messages. For the adaptor only.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/anchor_range.hpp>
#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <sensor_msgs/msg/imu.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/nav_sat_fix.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/model/robot.hpp"
#include "components/recordings/recorded_drive.hpp"

namespace bw {

/// What a log does not measure is marked so (first element of its covariance -1, REP 145); a variance it does
/// not declare is 0. `faster`: the drive is played so many times as fast as it went.
sensor_msgs::msg::Imu to_message(const ImuSample& sample, const std::string& frame, Time stamp,
                                 double faster);

sensor_msgs::msg::NavSatFix to_message(const FixSample& sample, const std::string& frame, Time stamp);

/// Frame: of the anchors, map.
bandwagon_msgs::msg::AnchorRange to_message(const RangeSample& sample, const std::string& frame, Time stamp);

sensor_msgs::msg::LaserScan to_message(const ScanSample& sample, const std::string& frame, Time stamp);

/// Frame: map. A heading that the reference does not have is an orientation that is none (all zeros), and no
/// speed (NaN). Nobody and no wall is known.
bandwagon_msgs::msg::GroundTruth to_message(const ReferencePose& reference, const Twist2& twist,
                                            const std::string& frame, Time stamp);

/// What this run calls a frame of the bag.
using Renamed = std::function<std::string(const std::string& frame)>;

/// The graph's own word on a sensor holds, and where the base is others tell.
void drop_what_others_tell(const Robot& robot, std::vector<FrameMount>& mounts);

tf2_msgs::msg::TFMessage to_message(const std::vector<FrameMount>& mounts, const Renamed& renamed,
                                    Time stamp);

}  // namespace bw
