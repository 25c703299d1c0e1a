// Between the occupancy grid of model/ and ROS 2's message. For adaptors only.
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

inline nav_msgs::msg::OccupancyGrid to_message(const OccupancyGrid& grid, const std::string& frame,
                                               Time stamp) {
  nav_msgs::msg::OccupancyGrid message;
  message.header(make_header(frame, stamp));
  message.info().map_load_time(to_stamp(stamp));
  message.info().resolution(static_cast<float>(grid.resolution));
  message.info().width(static_cast<std::uint32_t>(grid.width));
  message.info().height(static_cast<std::uint32_t>(grid.height));
  message.info().origin(to_pose({grid.origin.x(), grid.origin.y(), 0.0}));
  message.data().assign(grid.cells.begin(), grid.cells.end());
  return message;
}

/// Returns why the message is no usable grid (sizes, numbers, a rotated origin; `grid` is then unchanged), or
/// nothing.
inline std::string read_grid(const nav_msgs::msg::OccupancyGrid& message, OccupancyGrid& grid) {
  const auto& info = message.info();
  constexpr auto kMaxSide = static_cast<std::uint32_t>(std::numeric_limits<int>::max());
  if (info.width() == 0 || info.height() == 0 || info.width() > kMaxSide || info.height() > kMaxSide ||
      message.data().size() != std::size_t{info.width()} * info.height()) {
    return "its cells are not width * height";
  }
  // As in map files; a cell of a thousandth of that would make the fields around a map of one cell as large
  // as memory.
  if (!(info.resolution() >= 0.001F && info.resolution() <= 100.0F))
    return "its resolution is not between 0.001 and 100 m";
  const Pose2 origin = from_pose(info.origin());
  if (!is_finite(origin)) return "its origin is not finite";
  if (std::abs(origin.theta) > 1e-6) return "it is turned against its grid, which is not supported";
  // The message carries a float; a decimal such as 0.05 is meant, not the float nearest to it.
  grid.resolution = std::round(static_cast<double>(info.resolution()) * 1e6) / 1e6;
  grid.origin = origin.position();
  grid.width = static_cast<int>(info.width());
  grid.height = static_cast<int>(info.height());
  grid.cells.assign(message.data().begin(), message.data().end());
  return {};
}

}  // namespace bw
