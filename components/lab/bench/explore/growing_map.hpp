// The map that somebody with a laser that does not err makes of a building. Cells are those of the true map.
#pragma once

#include <cstddef>

#include "components/explore/wavefront.hpp"
#include "components/lab/bench/explore/coverage.hpp"

namespace bw {

class GrowingMap {
 public:
  /// Nothing is known yet; `place` lives as long.
  GrowingMap(const Explorable& place, double range);

  /// From the centre of a cell all around to `range` [m].
  void look(explore::Cell from);

  const OccupancyGrid& map() const { return map_; }
  bool is_known(std::size_t cell) const { return map_.cells[cell] != OccupancyGrid::kUnknown; }
  /// Share of the cells to explore that are known.
  double share() const { return static_cast<double>(seen_) / static_cast<double>(to_see_); }

 private:
  const Explorable& place_;
  double reach_;  ///< [cells]
  OccupancyGrid map_;
  std::size_t to_see_ = 0;
  std::size_t seen_ = 0;
};

}  // namespace bw
