// Maxima of the likelihood field over squares of cells: what bounds of a search over the map read.
#pragma once

#include <cstdint>
#include <vector>

#include "components/localization/laser/likelihood_field.hpp"
#include "components/model/pose2.hpp"

namespace bw::localization {

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
  /// Has a square free cells?
  bool free(int level, std::int32_t x, std::int32_t y) const;

  /// Coarsest squares side by side, columns and rows of them; square (i, j) starts at cell (i, j) *
  /// 2^coarsest.
  int blocks_x() const { return blocks_x_; }
  int blocks_y() const { return blocks_y_; }
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
  std::vector<std::int32_t> free_before_;          ///< free cells left of and below a corner (summed area)
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
