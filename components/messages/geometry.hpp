// Between the planar vocabulary of model/ and ROS 2's messages. For adaptors only.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <geometry_msgs/msg/pose.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/transform_stamped.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <nav_msgs/msg/path.hpp>
#include <std_msgs/msg/header.hpp>

#include "runtime/base/pose2.hpp"
#include "runtime/stamps.hpp"

namespace bw {

inline std_msgs::msg::Header make_header(const std::string& frame, Time stamp) {
  std_msgs::msg::Header header;
  header.frame_id(frame);
  header.stamp(to_stamp(stamp));
  return header;
}

inline geometry_msgs::msg::Point to_point(const Vector2& p) {
  geometry_msgs::msg::Point point;
  point.x(p.x());
  point.y(p.y());
  return point;
}

inline geometry_msgs::msg::Vector3 to_vector3(const Vector2& v) {
  geometry_msgs::msg::Vector3 vector;
  vector.x(v.x());
  vector.y(v.y());
  return vector;
}

inline geometry_msgs::msg::Quaternion to_quaternion(double yaw) {
  geometry_msgs::msg::Quaternion q;
  q.z(std::sin(yaw / 2.0));
  q.w(std::cos(yaw / 2.0));
  return q;
}

/// Heading [rad] of a rotation; NaN for a quaternion that is none (not of unit length within 1 %).
inline double yaw_of(const geometry_msgs::msg::Quaternion& q) {
  const double norm = q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w();
  if (!(std::abs(norm - 1.0) < 0.02)) return std::numeric_limits<double>::quiet_NaN();
  return std::atan2(2.0 * (q.w() * q.z() + q.x() * q.y()), 1.0 - 2.0 * (q.y() * q.y() + q.z() * q.z()));
}

inline geometry_msgs::msg::Pose to_pose(const Pose2& X) {
  geometry_msgs::msg::Pose pose;
  pose.position(to_point(X.position()));
  pose.orientation(to_quaternion(X.theta));
  return pose;
}

/// May hold NaN when the message does: check with is_finite().
inline Pose2 from_pose(const geometry_msgs::msg::Pose& pose) {
  return {pose.position().x(), pose.position().y(), yaw_of(pose.orientation())};
}

/// What keeps a pose that a person or a program sent from being one; empty: nothing. As in ROS's move_base a
/// quaternion shorter than 0.001 has no direction: it is more likely a forgotten orientation than a wish to
/// face along x.
inline std::string fault_of(const geometry_msgs::msg::Pose& pose) {
  constexpr double kShortestSquared = 1e-6;
  const auto& p = pose.position();
  const auto& q = pose.orientation();
  if (!std::isfinite(p.x()) || !std::isfinite(p.y()) || !std::isfinite(p.z()))
    return "the position is not finite";
  const double squared = q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w();
  if (!std::isfinite(squared)) return "the quaternion is not finite";
  if (squared < kShortestSquared) return "the quaternion has length 0 (no rotation is x 0, y 0, z 0, w 1)";
  return {};
}

/// With a quaternion of length 1, as tf2 takes one of any other length; only for a pose without fault_of().
inline geometry_msgs::msg::Pose normalised(const geometry_msgs::msg::Pose& pose) {
  const auto& q = pose.orientation();
  const double length = std::sqrt(q.x() * q.x() + q.y() * q.y() + q.z() * q.z() + q.w() * q.w());
  geometry_msgs::msg::Pose result = pose;
  result.orientation().x(q.x() / length);
  result.orientation().y(q.y() / length);
  result.orientation().z(q.z() / length);
  result.orientation().w(q.w() / length);
  return result;
}

inline constexpr Eigen::Index kPlanar[] = {0, 1, 5};  ///< x, y, yaw among x, y, z, roll, pitch, yaw

/// (x, y, yaw) of the covariance of a message.
inline Eigen::Matrix3d planar_covariance(const std::array<double, 36>& covariance) {
  return Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(covariance.data())(kPlanar, kPlanar);
}

inline void set_planar_covariance(std::array<double, 36>& covariance, const Eigen::Matrix3d& C) {
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>>(covariance.data())(kPlanar, kPlanar) = C;
}

inline geometry_msgs::msg::Twist to_twist_message(const Twist2& t) {
  geometry_msgs::msg::Twist twist;
  twist.linear().x(t.v);
  twist.angular().z(t.omega);
  return twist;
}

inline Twist2 from_twist(const geometry_msgs::msg::Twist& twist) {
  return {twist.linear().x(), twist.angular().z()};
}

inline geometry_msgs::msg::TransformStamped to_transform(const std::string& parent, const std::string& child,
                                                         Time stamp, const Pose2& X_PC) {
  geometry_msgs::msg::TransformStamped transform;
  transform.header(make_header(parent, stamp));
  transform.child_frame_id(child);
  transform.transform().translation(to_vector3(X_PC.position()));
  transform.transform().rotation(to_quaternion(X_PC.theta));
  return transform;
}

inline nav_msgs::msg::Path to_path(const std::string& frame, Time stamp, const std::vector<Pose2>& poses) {
  nav_msgs::msg::Path path;
  path.header(make_header(frame, stamp));
  path.poses().reserve(poses.size());
  for (const Pose2& X : poses) {
    geometry_msgs::msg::PoseStamped stamped;
    stamped.header(path.header());
    stamped.pose(to_pose(X));
    path.poses().push_back(std::move(stamped));
  }
  return path;
}

inline std::vector<Pose2> from_path(const nav_msgs::msg::Path& path) {
  std::vector<Pose2> poses;
  poses.reserve(path.poses().size());
  for (const auto& stamped : path.poses()) poses.push_back(from_pose(stamped.pose()));
  return poses;
}

}  // namespace bw
