// A map that was made, beside the true one.
#pragma once

#include <cstddef>

#include "components/model/occupancy_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::slam {

/// Of occupied cells, one cell more or less apart.
struct MapScore {
  std::size_t drawn = 0;  ///< occupied cells of the map
  std::size_t right = 0;  ///< of these, with a wall of the true one within one cell
  std::size_t walls = 0;  ///< occupied cells of the true one
  std::size_t found = 0;  ///< of these, with one of the map within one cell
  double precision() const {
    return drawn == 0 ? 0.0 : static_cast<double>(right) / static_cast<double>(drawn);
  }
  double recall() const { return walls == 0 ? 0.0 : static_cast<double>(found) / static_cast<double>(walls); }
  /// Harmonic mean of the two.
  double f1() const {
    const double sum = precision() + recall();
    return sum > 0.0 ? 2.0 * precision() * recall() / sum : 0.0;
  }
};

/// X_TM: the frame of `made` in that of `truth`. Within one cell: the cell that a centre lies in, or one of
/// the eight around it.
MapScore score_map(const OccupancyGrid& made, const OccupancyGrid& truth, const Pose2& X_TM);

}  // namespace bw::slam
