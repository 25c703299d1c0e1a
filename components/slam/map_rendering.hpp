// The map that scans at their poses draw: how often beams ended in a cell, and went through it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/model/occupancy_grid.hpp"
#include "components/slam/scan.hpp"
#include "components/slam/tiled_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::slam {

/// Cells that changed, as rows of the map: what map_msgs/OccupancyGridUpdate carries.
struct MapRegion {
  int column = 0;
  int row = 0;
  int width = 0;
  int height = 0;
};

class MapRendering {
 public:
  explicit MapRendering(double resolution) : resolution_(resolution) {}

  /// Draws a scan at X_MB, or takes it back: what was drawn once at a pose can be taken back at the same
  /// pose, up to 30,000 beams through one cell (theory.md 10.12).
  void draw(const RangeImage& image, const Pose2& X_MB) { add(image, X_MB, 1); }
  void erase(const RangeImage& image, const Pose2& X_MB) { add(image, X_MB, -1); }

  /// All that was drawn, with a margin of one tile; its origin and size grow in steps of a tile. Without
  /// scans: an empty grid. kOccupied, kFree or kUnknown: a cell is occupied where beams ended in at least a
  /// quarter of the times that they came to it.
  OccupancyGrid grid() const;

  std::size_t bytes() const { return cells_.bytes(); }

 private:
  struct Counts {
    std::int16_t hits = 0;
    std::int16_t passes = 0;
  };
  void add(const RangeImage& image, const Pose2& X_MB, int sign);
  void count(int i, int j, int hits, int passes);

  double resolution_;
  TiledGrid<Counts> cells_;
};

}  // namespace bw::slam
