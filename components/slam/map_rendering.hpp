// The map that scans at their poses draw: how often beams ended in a cell, and went through it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <vector>

#include "components/model/occupancy_grid.hpp"
#include "components/slam/scan.hpp"
#include "components/slam/tiled_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::slam {

/// A square piece of the map as it is now. Its lower left cell is (column, row) times kEdge.
struct MapTile {
  static constexpr int kEdge = 32;  ///< cells
  int column = 0;
  int row = 0;
  std::array<std::int8_t, std::size_t{kEdge} * kEdge> cells{};  ///< row-major: as in OccupancyGrid
};

/// Cells of the largest map: as many as a map file may have (components/files/map_image.hpp), 400 x 400 m at 5 cm.
inline constexpr double kMostCells = 64 << 20;

struct PlacedScan {
  Pose2 X_MB;
  std::shared_ptr<const RangeImage> ranges;
};

/// The map that these draw, as MapRendering does.
OccupancyGrid render(std::span<const PlacedScan> scans, double resolution);

class MapRendering {
 public:
  explicit MapRendering(double resolution) : resolution_(resolution) {}

  /// Draws a scan at X_MB. False, and nothing is drawn, where the box about all would then have more than kMostCells.
  bool draw(const RangeImage& image, const Pose2& X_MB);
  /// Takes it back: what was drawn once at a pose can be taken back at the same pose, up to 30,000 beams through one
  /// cell (theory.md 10.12).
  void erase(const RangeImage& image, const Pose2& X_MB) { add(image, X_MB, -1); }

  /// All that was drawn, with a margin of one tile; its origin and size grow in steps of a tile. Without
  /// scans: an empty grid. kOccupied, kFree or kUnknown: a cell is occupied where beams ended in at least a
  /// quarter of the times that they came to it.
  OccupancyGrid grid() const;

  /// Tiles that were drawn to, or taken back, and not gathered since.
  std::size_t changed_tiles() const { return changed_.size(); }
  /// Adds up to `most` of them to `tiles`, those that changed first; costs a microsecond each.
  void gather(std::size_t most, std::vector<MapTile>& tiles);

  std::size_t bytes() const { return cells_.bytes(); }

 private:
  struct Counts {
    std::int16_t hits = 0;
    std::int16_t passes = 0;
  };
  struct TileIndex {
    int column = 0;
    int row = 0;
    bool operator==(const TileIndex&) const = default;
  };
  /// [cells] the box about all that was drawn, an upper bound.
  struct Box {
    Vector2 low{0.0, 0.0};
    Vector2 high{0.0, 0.0};
  };
  static std::int8_t value_of(const Counts& counts);
  void add(const RangeImage& image, const Pose2& X_MB, int sign);
  void count(int i, int j, int hits, int passes);
  void mark(const TileIndex& tile);

  double resolution_;
  Box drawn_;
  TiledGrid<Counts> cells_;
  std::deque<TileIndex> changed_;
  TiledGrid<std::uint8_t> is_changed_;  ///< by tile: it is in changed_
  TileIndex last_;                      ///< the tile that was counted in last
  bool is_last_marked_ = false;
};

}  // namespace bw::slam
