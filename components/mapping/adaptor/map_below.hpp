// The map beneath a local costmap: what it says of cells that nobody has seen.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "components/mapping/costmap/map_fill.hpp"
#include "components/messages/map_input.hpp"
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
    map_ = listen_to_map(setup);
  }

  /// `cells` are in odom.
  void fill(OccupancyGrid& cells) const {
    if (!map_ || map_->frame.empty()) return;
    if (const auto X_MO = transforms_->lookup_planar(map_->frame, odom_frame_))
      fill_unknown(cells, map_->grid, *X_MO, {});
  }

 private:
  std::shared_ptr<const TransformTree> transforms_;
  std::string odom_frame_;
  std::shared_ptr<const KnownMap> map_;
};

}  // namespace bw::costmap
