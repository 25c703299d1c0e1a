// What becomes of the map beside the scans: topics `map` and `map_updates`, answers, files. Where time is real all of it
// is done by one thread of its own, so that a map of many megabytes or a slow disk delays no scan; in lock-step at once.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <map_msgs/msg/occupancy_grid_update.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/srv/get_map.hpp>

#include "components/slam/published_map.hpp"
#include "runtime/component.hpp"
#include "runtime/serial/background_jobs.hpp"

namespace bw::slam {

class MapOutput {
 public:
  void configure(Setup& setup);
  void activate();
  /// Returns when all is done.
  void deactivate();

  /// A new map: what was told before is no part of it.
  void begin(double resolution);
  /// What changed in one interval. False: the one before is still being written, ask again.
  bool send(std::vector<MapTile>& tiles, Time stamp);
  /// The map as it was told last.
  void answer(const Reply<nav_msgs::srv::GetMap>& reply, Time stamp);
  /// Does this after what was asked for before.
  void add(std::function<void()> job);

 private:
  void publish(PublishedMap& map, const std::vector<MapTile>& tiles, Time stamp) const;

  bool is_lockstep_ = false;
  std::string frame_;
  Output<nav_msgs::msg::OccupancyGrid> map_;
  Output<map_msgs::msg::OccupancyGridUpdate> updates_;
  std::shared_ptr<PublishedMap> published_;  ///< the thread's while it is busy
  std::atomic<bool> busy_ = false;
  std::unique_ptr<BackgroundJobs> jobs_;  ///< last: it ends before what it uses
};

}  // namespace bw::slam
