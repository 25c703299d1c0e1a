// What a base tells of itself, simulated, real or recorded: its odometry, odom->base_link, and where its
// sensors sit.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/odometry.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"

namespace bw {

class OdometryOutputs {
 public:
  OdometryOutputs() = default;
  OdometryOutputs(Setup& setup, const Robot& robot)
      : odom_frame_(setup.frame("odom")),
        base_frame_(setup.frame("base_link")),
        odom_(setup.output<nav_msgs::msg::Odometry>("odom")),
        tf_(setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())),
        tf_static_(setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched())) {
    for (const SensorMount& mount : robot.sensors)
      mounts_.emplace_back(setup.frame(mount.frame), robot.mount_of(mount.frame));
  }

  /// `mounts`: what sits elsewhere than the robot's sensors, told with them.
  void publish_mounts(Time now, tf2_msgs::msg::TFMessage mounts = {}) {
    for (const auto& [frame, X_BS] : mounts_)
      mounts.transforms().push_back(to_transform(base_frame_, frame, now, X_BS));
    tf_static_.publish(mounts);
  }

  void publish_odometry(const OdometryState& state) {
    odom_.publish(to_odometry(state, odom_frame_, base_frame_));
  }

  void publish_transform(const OdometryState& state) {
    tf2_msgs::msg::TFMessage tf;
    tf.transforms().push_back(to_transform(odom_frame_, base_frame_, state.time, state.X_OB));
    tf_.publish(tf);
  }

 private:
  std::string odom_frame_;
  std::string base_frame_;
  Output<nav_msgs::msg::Odometry> odom_;
  Output<tf2_msgs::msg::TFMessage> tf_;
  Output<tf2_msgs::msg::TFMessage> tf_static_;
  std::vector<std::pair<std::string, Pose2>> mounts_;  ///< frame and pose in base_link of every sensor
};

}  // namespace bw
