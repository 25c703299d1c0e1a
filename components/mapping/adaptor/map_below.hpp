// The map beneath a local costmap: what it says of cells that nobody has seen.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include <nav_msgs/msg/occupancy_grid.hpp>

#include "components/mapping/costmap/map_fill.hpp"
#include "components/messages/grid.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw::costmap {

/// Nothing is filled before listen(), before a usable map came, and while its frame is not connected. Lives
/// in the component whose setup it is given.
class MapBelow {
 public:
  void listen(Setup& setup, std::shared_ptr<const TransformTree> transforms) {
    transforms_ = std::move(transforms);
    odom_frame_ = setup.frame("odom");
    log_ = setup.log();
    setup.input<nav_msgs::msg::OccupancyGrid>("map", Qos::latched(),
                                              [this](const auto& message, const Tick&) { keep(message); });
  }

  /// `cells` are in odom.
  void fill(OccupancyGrid& cells) const {
    if (frame_.empty()) return;
    if (const auto X_MO = transforms_->lookup_planar(frame_, odom_frame_))
      fill_unknown(cells, map_, *X_MO, {});
  }

 private:
  void keep(const nav_msgs::msg::OccupancyGrid& message) {
    const std::string fault = read_grid(message, map_);
    if (fault.empty()) {
      frame_ = message.header().frame_id();
    } else {
      log_.warn("the map is not used: {}", fault);
    }
  }

  std::shared_ptr<const TransformTree> transforms_;
  std::string odom_frame_;
  Logger log_;
  OccupancyGrid map_;
  std::string frame_;  ///< of the map; empty until a usable one came
};

}  // namespace bw::costmap
