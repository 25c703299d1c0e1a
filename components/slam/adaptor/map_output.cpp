#include "components/slam/adaptor/map_output.hpp"

#include <algorithm>
#include <utility>

#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"

namespace bw::slam {
namespace {

map_msgs::msg::OccupancyGridUpdate to_update(const OccupancyGrid& grid, const MapRegion& part,
                                             const std::string& frame, Time stamp) {
  map_msgs::msg::OccupancyGridUpdate message;
  message.header(make_header(frame, stamp));
  message.x(part.column);
  message.y(part.row);
  message.width(static_cast<std::uint32_t>(part.width));
  message.height(static_cast<std::uint32_t>(part.height));
  message.data().reserve(static_cast<std::size_t>(part.width) * static_cast<std::size_t>(part.height));
  for (int row = part.row; row < part.row + part.height; ++row) {
    const auto from = grid.cells.begin() + static_cast<std::ptrdiff_t>(grid.index(part.column, row));
    message.data().insert(message.data().end(), from, from + part.width);
  }
  return message;
}

}  // namespace

void MapOutput::configure(Setup& setup) {
  is_lockstep_ = setup.is_lockstep();
  frame_ = setup.frame("map");
  map_ = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched());
  updates_ = setup.output<map_msgs::msg::OccupancyGridUpdate>("map_updates");
}

void MapOutput::activate() {
  if (!is_lockstep_ && !jobs_) jobs_ = std::make_unique<BackgroundJobs>();
}

void MapOutput::deactivate() { jobs_.reset(); }

void MapOutput::begin(double resolution) { published_ = std::make_shared<PublishedMap>(resolution); }

bool MapOutput::send(std::vector<MapTile>& tiles, Time stamp) {
  if (jobs_) jobs_->rethrow();
  if (busy_) return false;
  busy_ = true;
  add([this, map = published_, tiles = std::move(tiles), stamp] {
    publish(*map, tiles, stamp);
    busy_ = false;
  });
  tiles.clear();
  return true;
}

void MapOutput::answer(const Reply<nav_msgs::srv::GetMap>& reply, Time stamp) {
  add([reply, map = published_, frame = frame_, stamp] {
    nav_msgs::srv::GetMap::Response response;
    response.map(to_message(map->grid(), frame, stamp));
    reply(response);
  });
}

void MapOutput::add(std::function<void()> job) {
  if (jobs_)
    jobs_->add(std::move(job));
  else
    job();
}

void MapOutput::publish(PublishedMap& map, const std::vector<MapTile>& tiles, Time stamp) const {
  switch (map.next(tiles)) {
    case PublishedMap::News::none:
      return;
    case PublishedMap::News::part:
      return updates_.publish(to_update(map.grid(), map.part(), frame_, stamp));
    case PublishedMap::News::whole:
      return map_.publish(to_message(map.grid(), frame_, stamp));
  }
}

}  // namespace bw::slam
