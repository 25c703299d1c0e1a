// The map of a SLAM under way, drawn a few scans at a time: new ones, and again those whose pose moved; without those that left it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "components/slam/map_rendering.hpp"
#include "components/slam/slam.hpp"

namespace bw::slam {

class MapPainter {
 public:
  MapPainter(double resolution, const Pose2& X_MW)
      : resolution_(resolution), X_MW_(X_MW), rendering_(resolution) {}

  /// Draws at most `most` scans. X_MW: what Slam calls its map, in the frame that is drawn in. False: all is as it
  /// should be.
  bool update(const Slam& slam, int most);
  /// All that is left to draw.
  void finish(const Slam& slam) {
    while (update(slam, 1000)) {
    }
  }

  /// Counts up with each scan that was drawn.
  std::int64_t drawn() const { return drawn_; }
  OccupancyGrid grid() const { return rendering_.grid(); }
  /// As MapRendering's.
  std::size_t changed_tiles() const { return rendering_.changed_tiles(); }
  void gather(std::size_t most, std::vector<MapTile>& tiles) { rendering_.gather(most, tiles); }

 private:
  bool moved(const Pose2& from, const Pose2& to) const;

  double resolution_;
  Pose2 X_MW_;
  MapRendering rendering_;
  struct Drawn {
    Pose2 X_MB;
    std::shared_ptr<const RangeImage> ranges;
  };
  std::map<std::size_t, Drawn> drawn_nodes_;  ///< by number, as they were drawn
  std::size_t next_new_ = 0;                  ///< number of the node that is drawn next
  std::int64_t revision_ = 0;                 ///< of the poses that are looked at
  std::size_t next_again_ = 0;  ///< number of the node that is looked at next: did it move or leave?
  std::int64_t drawn_ = 0;
};

}  // namespace bw::slam
