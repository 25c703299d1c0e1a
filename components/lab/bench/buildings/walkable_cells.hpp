// Where people can go in a building, and short ways there. Frame: map.
#pragma once

#include <cstdint>
#include <vector>

#include "components/lab/bench/buildings/building.hpp"
#include "components/lab/bench/buildings/wall_index.hpp"
#include "components/model/occupancy_grid.hpp"
#include "components/model/random.hpp"

namespace bw::buildings {

/// Of a person's centre from the walls: their legs (world/legs.hpp) reach 0.286 m at full swing.
inline constexpr double kPersonClearance = 0.3;  ///< [m]

class WalkableCells {
 public:
  /// All that are connected with the start of the building's route. `walls` are those of the building, and
  /// live as long.
  WalkableCells(const Building& building, const WallIndex& walls);

  Vector2 drawn_place(Random& random) const;

  /// Corners on the way from a place to the centre of a cell, the last one first, cut short where no wall is
  /// in between. On every straight part a person has room.
  std::vector<Vector2> way(const Vector2& from, const Vector2& to) const;

  Vector2 nearest_center(const Vector2& place) const;

 private:
  /// For each cell that is nearer to `first` than `last` is, in steps: the one before it; -1: not reached.
  std::vector<std::int32_t> reach(std::size_t first, std::size_t last) const;
  std::size_t nearest_cell(const Vector2& place) const;
  Vector2 center_of(std::size_t cell) const;
  bool has_room_between(const Vector2& a, const Vector2& b) const;

  const WallIndex& walls_;
  OccupancyGrid grid_;              ///< kFree: walkable
  std::vector<std::size_t> cells_;  ///< those
};

}  // namespace bw::buildings
