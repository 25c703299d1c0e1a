// The state of the odometry as nav_msgs/Odometry.
#pragma once

#include <string>

#include <nav_msgs/msg/odometry.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/odometry_state.hpp"

namespace bw {

inline nav_msgs::msg::Odometry to_odometry(const OdometryState& state, const std::string& odom_frame,
                                           const std::string& base_frame) {
  nav_msgs::msg::Odometry message;
  message.header(make_header(odom_frame, state.time));
  message.child_frame_id(base_frame);
  message.pose().pose(to_pose(state.X_OB));
  message.twist().twist(to_twist_message(state.twist));
  set_planar_covariance(message.pose().covariance(), state.pose_covariance);
  message.twist().covariance()[0] = state.twist_covariance(0, 0);
  message.twist().covariance()[35] = state.twist_covariance(1, 1);
  return message;
}

}  // namespace bw
