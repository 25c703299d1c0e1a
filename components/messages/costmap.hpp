// Costs as nav2_msgs/Costmap. For adaptors only.
#pragma once

#include <string>
#include <vector>

#include <nav2_msgs/msg/costmap.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

/// `costs` are those of the cells of `grid`, by cell_cost.hpp.
inline nav2_msgs::msg::Costmap to_costmap(const OccupancyGrid& grid, const std::vector<std::uint8_t>& costs,
                                          const std::string& frame, Time stamp) {
  nav2_msgs::msg::Costmap message;
  message.header(make_header(frame, stamp));
  message.metadata().map_load_time(to_stamp(stamp));
  message.metadata().update_time(to_stamp(stamp));
  message.metadata().layer("master");
  message.metadata().resolution(static_cast<float>(grid.resolution));
  message.metadata().size_x(static_cast<std::uint32_t>(grid.width));
  message.metadata().size_y(static_cast<std::uint32_t>(grid.height));
  message.metadata().origin(to_pose({grid.origin.x(), grid.origin.y(), 0.0}));
  message.data().assign(costs.begin(), costs.end());
  return message;
}

}  // namespace bw
