// The parts that every marker for rviz2 has.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <visualization_msgs/msg/marker.hpp>

#include "components/messages/geometry.hpp"

namespace bw {

using Color = std::array<float, 4>;  ///< red, green, blue, opacity: each 0 to 1

inline std_msgs::msg::ColorRGBA to_color(const Color& color) {
  std_msgs::msg::ColorRGBA message;
  message.r(color[0]);
  message.g(color[1]);
  message.b(color[2]);
  message.a(color[3]);
  return message;
}

inline void paint(visualization_msgs::msg::Marker& marker, const Color& color) {
  marker.color(to_color(color));
}

/// At the origin of the header's frame, without size. It vanishes by itself after `lifetime`; zero: never.
inline visualization_msgs::msg::Marker make_marker(const std::string& name_space, std::int32_t id,
                                                   std::int32_t type, Duration lifetime,
                                                   const std_msgs::msg::Header& header) {
  visualization_msgs::msg::Marker marker;
  marker.header(header);
  marker.ns(name_space);
  marker.id(id);
  marker.type(type);
  marker.action(visualization_msgs::msg::Marker_Constants::ADD);
  marker.lifetime(to_message(lifetime));
  marker.pose(to_pose({}));
  return marker;
}

}  // namespace bw
