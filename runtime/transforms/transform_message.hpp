// A geometry_msgs/Transform as a rotation and translation in space.
#pragma once

#include <Eigen/Geometry>
#include <geometry_msgs/msg/transform.hpp>

namespace bw {

/// X_PC: the child in its parent. The quaternion is taken as it is; a tree refuses what is none.
inline Eigen::Isometry3d to_isometry(const geometry_msgs::msg::Transform& transform) {
  const auto& p = transform.translation();
  const auto& q = transform.rotation();
  Eigen::Isometry3d X_PC = Eigen::Isometry3d::Identity();
  X_PC.translation() << p.x(), p.y(), p.z();
  X_PC.linear() = Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z()).toRotationMatrix();
  return X_PC;
}

}  // namespace bw
