// A submap's likelihood, and for squares of 2, 4, 8, ... cells the largest in them: what branch and bound reads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "components/slam/surface_map.hpp"

namespace bw::slam {

class MaxGrids {
 public:
  static constexpr int kLevels = 6;
  /// [m] edge of a cell
  static constexpr double kCell = 0.1;
  /// [m] spread of the likelihood about a wall
  static constexpr double kSpread = 0.12;
  /// [m] from the submap's frame; walls farther away are left out, which bounds the memory
  static constexpr double kReach = 120.0;

  explicit MaxGrids(std::span<const Surface> surfaces);

  /// Largest likelihood in 255ths over the square of 2^level cells whose lower left cell is (i, j).
  int at(int level, int i, int j) const {
    const int column = i - first_column_;
    const int row = j - first_row_;
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return 0;
    return levels_[static_cast<std::size_t>(level)]
                  [static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(column)];
  }
  std::size_t bytes() const { return levels_.size() * (levels_.empty() ? 0 : levels_.front().size()); }

 private:
  int first_column_ = 0;
  int first_row_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::vector<std::uint8_t>> levels_;
};

}  // namespace bw::slam
