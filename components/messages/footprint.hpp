// The robot's footprint as messages. For adaptors only.
#pragma once

#include <utility>
#include <vector>

#include <geometry_msgs/msg/polygon_stamped.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/footprint_outline.hpp"

namespace bw {

inline void add_point(geometry_msgs::msg::Polygon& polygon, const Vector2& at) {
  geometry_msgs::msg::Point32 point;
  point.x(static_cast<float>(at.x()));
  point.y(static_cast<float>(at.y()));
  polygon.points().push_back(point);
}

/// As Nav2's costmaps publish it; of a disc 16 corners on its rim, as Nav2 makes them of a `robot_radius`.
/// X_FB: the robot in the header's frame.
inline geometry_msgs::msg::PolygonStamped to_published_footprint(const Pose2& X_FB,
                                                                 const Footprint& footprint,
                                                                 const std_msgs::msg::Header& header) {
  constexpr int kCorners = 16;
  geometry_msgs::msg::PolygonStamped message;
  message.header(header);
  for (const Vector2& corner : outline(footprint, X_FB, kCorners)) add_point(message.polygon(), corner);
  return message;
}

/// In base_link. A disc is one point, its radius ahead.
inline geometry_msgs::msg::Polygon to_polygon(const Footprint& footprint) {
  geometry_msgs::msg::Polygon message;
  for (const Vector2& corner : footprint.polygon) add_point(message, corner);
  if (!footprint.is_polygon()) add_point(message, {footprint.radius, 0.0});
  return message;
}

/// Corners in base_link, or why they are no outline.
inline FootprintResult to_footprint(const geometry_msgs::msg::Polygon& message) {
  std::vector<Vector2> corners;
  for (const auto& point : message.points()) corners.emplace_back(point.x(), point.y());
  return footprint_of(std::move(corners));
}

/// The same, and a disc of one point.
inline FootprintResult to_polygon_or_disc(const geometry_msgs::msg::Polygon& message) {
  if (message.points().size() != 1) return to_footprint(message);
  const double radius = message.points().front().x();
  if (!(radius > 0.0 && radius <= kFarthestCorner)) return {{}, "must have a radius between 0 and 5 m"};
  return {{radius, {}}, {}};
}

}  // namespace bw
