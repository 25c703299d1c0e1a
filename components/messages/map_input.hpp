// A map as it is by now: topic `map` with whole maps, and `map_updates` with what changed since. For adaptors only.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <map_msgs/msg/occupancy_grid_update.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/messages/grid.hpp"
#include "components/model/occupancy_grid.hpp"
#include "runtime/complaint.hpp"
#include "runtime/component.hpp"

namespace bw {

struct KnownMap {
  OccupancyGrid grid;
  std::string frame;  ///< empty until a usable map came
};

/// Lays an update into the map that it is of. False, and nothing is changed, when it does not lie within it or
/// is in another frame.
inline bool lay_into(const map_msgs::msg::OccupancyGridUpdate& update, KnownMap& map) {
  if (update.x() < 0 || update.y() < 0) return false;
  const auto x = static_cast<std::uint64_t>(update.x());
  const auto y = static_cast<std::uint64_t>(update.y());
  const auto width = static_cast<std::uint64_t>(map.grid.width);
  if (x + update.width() > width || y + update.height() > static_cast<std::uint64_t>(map.grid.height))
    return false;
  if (update.data().size() != std::uint64_t{update.width()} * update.height()) return false;
  if (update.header().frame_id() != map.frame) return false;
  for (std::uint64_t row = 0; row < update.height(); ++row) {
    std::copy_n(update.data().begin() + static_cast<std::ptrdiff_t>(row * update.width()), update.width(),
                map.grid.cells.begin() + static_cast<std::ptrdiff_t>((y + row) * width + x));
  }
  return true;
}

using OnMap = std::function<void(const KnownMap& map, const Tick& tick)>;

/// The map of `topic`, kept up to date: `on_map` is called with each map, and with what an update makes of it. What is no
/// map is told in the log, and changes nothing.
inline std::shared_ptr<const KnownMap> listen_to_map(Setup& setup, OnMap on_map = {},
                                                     Need need = Need::required,
                                                     const std::string& topic = "map") {
  struct Followed {
    KnownMap map;
    Complaint fault;  ///< of the newest whole one, which updates are of
  };
  auto followed = std::make_shared<Followed>();
  const auto tell = [followed, on_map = std::move(on_map)](const Tick& tick) {
    if (on_map) on_map(followed->map, tick);
  };
  setup.input<nav_msgs::msg::OccupancyGrid>(
      topic, Qos::latched(),
      [followed, tell, topic, log = setup.log()](const nav_msgs::msg::OccupancyGrid& message,
                                                 const Tick& tick) {
        auto& [map, fault] = *followed;
        const std::string why = read_grid(message, map.grid);
        if (fault.is_news(why) && fault) log.warn("a map of {} is not used: {}", topic, why);
        if (fault) return;
        map.frame = message.header().frame_id();
        tell(tick);
      },
      need);
  setup.input<map_msgs::msg::OccupancyGridUpdate>(
      topic + "_updates", Qos::standard(),
      [followed, tell](const map_msgs::msg::OccupancyGridUpdate& update, const Tick& tick) {
        if (!followed->fault && lay_into(update, followed->map)) tell(tick);
      },
      Need::optional);
  return {followed, &followed->map};
}

}  // namespace bw
