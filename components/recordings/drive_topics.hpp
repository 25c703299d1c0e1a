// Where a bag has what a drive is made of.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/field.hpp"

namespace bw {

/// A topic that the bag does not have is none, unless it was named; an empty name is not looked for.
struct DriveTopics {
  std::string odometry = "/odom";
  std::string commands = "/cmd_vel";
  std::string wheels = "/joint_states";
  std::string imu = "/imu";
  std::string fixes = "/gps/fix";
  std::string ranges = "/ranges";
  std::string truth = "/ground_truth";
  std::vector<std::string> scans = {"/scan"};

  template <class Visitor>
  void fields(Visitor& v) {
    v("odometry", odometry, {.doc = "nav_msgs/Odometry"});
    v("commands", commands,
      {.doc = "geometry_msgs/TwistStamped, each held until the next; read where the bag has no odometry"});
    v("wheels", wheels,
      {.doc = "sensor_msgs/JointState of two wheels; read where the bag has neither odometry nor commands"});
    v("imu", imu, {.doc = "sensor_msgs/Imu, in axes of the base"});
    v("fixes", fixes, {.doc = "sensor_msgs/NavSatFix"});
    v("ranges", ranges, {.doc = "bandwagon_msgs/AnchorRange"});
    v("truth", truth,
      {.doc =
           "reference: geometry_msgs/PoseStamped, nav_msgs/Odometry or bandwagon_msgs/GroundTruth, in map"});
    v("scans", scans, {.doc = "sensor_msgs/LaserScan"});
  }
};

}  // namespace bw
