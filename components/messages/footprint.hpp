// The robot's disc as Nav2's costmaps publish a footprint. For adaptors only.
#pragma once

#include <numbers>

#include <geometry_msgs/msg/polygon_stamped.hpp>

#include "components/messages/geometry.hpp"

namespace bw {

/// A polygon of 16 corners on the rim of the disc, as Nav2 makes one of a `robot_radius`. X_FB: the robot in the header's frame.
inline geometry_msgs::msg::PolygonStamped to_footprint(const Pose2& X_FB, double radius,
                                                       const std_msgs::msg::Header& header) {
  constexpr int kCorners = 16;
  geometry_msgs::msg::PolygonStamped message;
  message.header(header);
  for (int i = 0; i < kCorners; ++i) {
    const Vector2 corner = X_FB * Vector2(radius * direction(2.0 * std::numbers::pi * i / kCorners));
    geometry_msgs::msg::Point32 point;
    point.x(static_cast<float>(corner.x()));
    point.y(static_cast<float>(corner.y()));
    message.polygon().points().push_back(point);
  }
  return message;
}

}  // namespace bw
