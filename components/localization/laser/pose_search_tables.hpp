// Maxima of the likelihood field over squares of cells: what bounds of a search over the map read.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "components/localization/laser/likelihood_field.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::localization {

/// Ends of beams [cells] from the cell of the base, and the box that holds them.
struct CellOffsets {
  std::vector<std::int32_t> x;
  std::vector<std::int32_t> y;
  std::int32_t least_x = 0;
  std::int32_t most_x = 0;
  std::int32_t least_y = 0;
  std::int32_t most_y = 0;
};

/// Values are log p of the field on a scale 0 (far from everything) to 255 (at an obstacle).
class PoseSearchTables {
 public:
  /// Finest squares have an edge of at most `step` [m] (one cell if cells are larger). Free: known, and at
  /// least `clearance` [m] from every obstacle.
  PoseSearchTables(const LikelihoodField& field, double step, double clearance);

  /// Squares of level h have 2^h cells on each side; of finest() the poses are compared, of coarsest() the
  /// bounds start.
  int finest() const { return finest_; }
  int coarsest() const { return finest_ + 2; }

  /// Maximum over the square of level `level` (0, finest to coarsest) whose lower left cell is (x, y),
  /// anywhere in or out of the table.
  std::int32_t at(int level, std::int32_t x, std::int32_t y) const {
    const std::int32_t column = x < 0 ? 0 : (x < width_ ? x : width_ - 1);
    const std::int32_t row = y < 0 ? 0 : (y < height_ ? y : height_ - 1);
    return levels_[static_cast<std::size_t>(level)]
                  [static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(column)];
  }
  /// Sums over `count` ends of at() for the four squares of level `level` at (x, y), right of it, above it,
  /// and both; an end is (end_x, end_y) cells from its square.
  std::array<std::int32_t, 4> sums(int level, std::int32_t x, std::int32_t y, const CellOffsets& ends) const;
  /// Has a square of a level from finest() to coarsest() free cells? (x, y) are multiples of its edge.
  bool free(int level, std::int32_t x, std::int32_t y) const {
    const FreeSquares& squares = free_[static_cast<std::size_t>(level - finest_)];
    const std::int32_t i = x >> level;
    const std::int32_t j = y >> level;
    return i < squares.width && j < squares.height &&
           squares.any[static_cast<std::size_t>(j) * static_cast<std::size_t>(squares.width) +
                       static_cast<std::size_t>(i)] != 0;
  }

  /// Coarsest squares side by side, columns and rows of them. Square (i, j) starts at the cell
  /// (i, j) * 2^coarsest.
  int blocks_x() const { return blocks_x_; }
  int blocks_y() const { return blocks_y_; }
  /// Those with free cells, as j * blocks_x + i.
  const std::vector<std::uint32_t>& free_blocks() const { return free_blocks_; }
  /// bounds[j * blocks_x + i] += bound, less outside(), of the value at any cell of square (i, j) moved by
  /// (x, y) cells.
  void add_bounds(std::int32_t x, std::int32_t y, std::vector<std::int16_t>& bounds) const;

  /// Value of all that is not in the table.
  std::int32_t outside() const { return outside_; }

  /// Position of a cell's centre, in the map's frame [m].
  Vector2 center(double x, double y) const {
    return origin_ + Vector2{(x + 0.5) * resolution_, (y + 0.5) * resolution_};
  }
  /// Cell that holds a position.
  std::int32_t column_of(double x) const;
  std::int32_t row_of(double y) const;
  double resolution() const { return resolution_; }

 private:
  void build_levels(const LikelihoodField& field);
  void build_free(const LikelihoodField& field, double clearance);
  void build_phases();

  double resolution_;
  Vector2 origin_;
  std::int32_t width_;  ///< [cells], the field's with a border at its left and lower edge
  std::int32_t height_;
  std::int32_t border_;
  int finest_;
  std::int32_t outside_ = 0;                       ///< value of what is outside
  std::vector<std::vector<std::uint8_t>> levels_;  ///< by level; sliding maxima, row-major
  struct FreeSquares {
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::vector<std::uint8_t> any;
  };
  std::vector<FreeSquares> free_;  ///< by level, from finest_
  std::vector<std::uint32_t> free_blocks_;
  int blocks_x_;
  int blocks_y_;
  /// Coarsest maxima at every stride_-th cell, less outside_: one plane for each of the columns k modulo 4,
  /// so that what neighbouring squares read stands side by side.
  std::int32_t stride_;
  std::int32_t phase_width_;
  std::int32_t phase_height_;
  std::vector<std::int16_t> phases_;
};

}  // namespace bw::localization
