// The map as others have it: laid together from tiles that changed, told whole or as the part that changed.
#pragma once

#include <span>

#include "components/model/occupancy_grid.hpp"
#include "components/slam/map_rendering.hpp"

namespace bw::slam {

/// Cells of a grid, counted from its lower left: what map_msgs/OccupancyGridUpdate carries.
struct MapRegion {
  int column = 0;
  int row = 0;
  int width = 0;
  int height = 0;
};

/// The map is told whole when its size or origin changed, and else at every `kIntervalsPerMap`th interval if
/// anything changed. Between, the box about all that changed since the last whole map is told: whoever came
/// late and has that map, or lost a part, has all again after the next part.
class PublishedMap {
 public:
  static constexpr int kIntervalsPerMap = 5;

  enum class News { none, part, whole };

  explicit PublishedMap(double resolution) { grid_.resolution = resolution; }

  /// Once per interval: lays tiles into the map.
  News next(std::span<const MapTile> tiles);

  /// Grows in steps of a tile, of an eighth of its side where that is more, and never gets smaller.
  const OccupancyGrid& grid() const { return grid_; }
  /// What to tell when the news is a part.
  MapRegion part() const;

 private:
  /// Corners in tiles; the upper ones are not in it.
  struct Box {
    int left = 0;
    int low = 0;
    int right = 0;
    int high = 0;
    bool empty() const { return left == right; }
    void add(int column, int row);
  };
  bool grow_to_hold(const Box& drawn);
  /// Whether a cell of it is another than before.
  bool lay(const MapTile& tile);

  OccupancyGrid grid_;
  Box box_;            ///< of the grid
  Box changed_;        ///< since the last whole map
  int intervals_ = 0;  ///< since the last whole map
};

}  // namespace bw::slam
