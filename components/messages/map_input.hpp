// A map that is told in parts: topic `map`, and what changed since in `map_updates`. For adaptors only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

#include <map_msgs/msg/occupancy_grid_update.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "runtime/component.hpp"

namespace bw {

/// Lays an update into the map that it is of. False, and nothing is changed, when it does not lie within it or
/// is in another frame.
inline bool lay_into(const map_msgs::msg::OccupancyGridUpdate& update, nav_msgs::msg::OccupancyGrid& map) {
  const std::uint64_t width = map.info().width();
  const std::uint64_t height = map.info().height();
  if (update.x() < 0 || update.y() < 0) return false;
  const auto x = static_cast<std::uint64_t>(update.x());
  const auto y = static_cast<std::uint64_t>(update.y());
  if (x + update.width() > width || y + update.height() > height) return false;
  if (update.data().size() != std::uint64_t{update.width()} * update.height()) return false;
  if (map.data().size() != width * height) return false;
  if (update.header().frame_id() != map.header().frame_id()) return false;
  for (std::uint64_t row = 0; row < update.height(); ++row) {
    std::copy_n(update.data().begin() + static_cast<std::ptrdiff_t>(row * update.width()), update.width(),
                map.data().begin() + static_cast<std::ptrdiff_t>((y + row) * width + x));
  }
  map.header().stamp(update.header().stamp());
  return true;
}

/// Calls on_map(map, tick) with each map, and with what an update makes of it.
template <class Callback>
void listen_to_map(Setup& setup, Callback on_map, Need need = Need::required) {
  auto map = std::make_shared<nav_msgs::msg::OccupancyGrid>();
  setup.input<nav_msgs::msg::OccupancyGrid>(
      "map", Qos::latched(),
      [map, on_map](const nav_msgs::msg::OccupancyGrid& message, const Tick& tick) {
        *map = message;
        on_map(std::as_const(*map), tick);
      },
      need);
  setup.input<map_msgs::msg::OccupancyGridUpdate>(
      "map_updates", Qos::standard(),
      [map, on_map](const map_msgs::msg::OccupancyGridUpdate& update, const Tick& tick) {
        if (lay_into(update, *map)) on_map(std::as_const(*map), tick);
      },
      Need::optional);
}

}  // namespace bw
