// A grid over the plane whose memory follows what was written: tiles of cells, made where something is.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace bw::slam {

/// Cell (i, j) spans [i, i + 1) x [j, j + 1) times the resolution; both may be negative.
template <class Cell>
class TiledGrid {
 public:
  static constexpr int kEdgeBits = 5;
  static constexpr int kEdge = 1 << kEdgeBits;  ///< cells along a tile

  /// What was written at (i, j), else a cell as made.
  const Cell& at(int i, int j) const {
    const int column = (i >> kEdgeBits) - first_column_;
    const int row = (j >> kEdgeBits) - first_row_;
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return empty_;
    const Tile* tile = tiles_[index(column, row)].get();
    return tile == nullptr ? empty_ : (*tile)[cell(i, j)];
  }
  /// To write to. Cells stay where they are in memory: to move them all would take long in a large map.
  Cell& ref(int i, int j) {
    const int tile_column = i >> kEdgeBits;
    const int tile_row = j >> kEdgeBits;
    if (tile_column < first_column_ || tile_row < first_row_ || tile_column >= first_column_ + columns_ ||
        tile_row >= first_row_ + rows_)
      grow(tile_column, tile_row);
    std::unique_ptr<Tile>& tile = tiles_[index(tile_column - first_column_, tile_row - first_row_)];
    if (!tile) {
      tile = std::make_unique<Tile>();
      ++made_;
    }
    return (*tile)[cell(i, j)];
  }
  /// The cells of the tile that (i, j) lies in, row-major; null where nothing was written.
  const Cell* tile_of(int i, int j) const {
    const int column = (i >> kEdgeBits) - first_column_;
    const int row = (j >> kEdgeBits) - first_row_;
    if (column < 0 || row < 0 || column >= columns_ || row >= rows_) return nullptr;
    const Tile* tile = tiles_[index(column, row)].get();
    return tile == nullptr ? nullptr : tile->data();
  }
  std::size_t bytes() const {
    return made_ * sizeof(Tile) + tiles_.capacity() * sizeof(std::unique_ptr<Tile>);
  }
  bool empty() const { return made_ == 0; }

  /// fn(i, j, cell) for each cell of each tile, by rows of tiles.
  template <class Function>
  void for_each(Function&& fn) const {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const Tile* tile = tiles_[index(column, row)].get();
        if (tile == nullptr) continue;
        const int i0 = (column + first_column_) * kEdge;
        const int j0 = (row + first_row_) * kEdge;
        for (int j = 0; j < kEdge; ++j)
          for (int i = 0; i < kEdge; ++i) fn(i0 + i, j0 + j, (*tile)[cell(i, j)]);
      }
    }
  }

 private:
  using Tile = std::array<Cell, std::size_t{kEdge} * kEdge>;  ///< row-major
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  static std::size_t cell(int i, int j) {
    return (static_cast<std::size_t>(j & (kEdge - 1)) << kEdgeBits) +
           static_cast<std::size_t>(i & (kEdge - 1));
  }
  void grow(int tile_column, int tile_row) {
    constexpr int kMargin = 4;
    const bool none = tiles_.empty();
    const int left = none ? tile_column - kMargin : std::min(first_column_, tile_column - kMargin);
    const int low = none ? tile_row - kMargin : std::min(first_row_, tile_row - kMargin);
    const int right =
        none ? tile_column + kMargin : std::max(first_column_ + columns_ - 1, tile_column + kMargin);
    const int high = none ? tile_row + kMargin : std::max(first_row_ + rows_ - 1, tile_row + kMargin);
    const int columns = right - left + 1;
    const int rows = high - low + 1;
    std::vector<std::unique_ptr<Tile>> tiles(static_cast<std::size_t>(columns) *
                                             static_cast<std::size_t>(rows));
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column)
        tiles[static_cast<std::size_t>(row + first_row_ - low) * static_cast<std::size_t>(columns) +
              static_cast<std::size_t>(column + first_column_ - left)] =
            std::move(tiles_[index(column, row)]);
    tiles_ = std::move(tiles);
    first_column_ = left;
    first_row_ = low;
    columns_ = columns;
    rows_ = rows;
  }

  static inline const Cell empty_{};
  int first_column_ = 0;
  int first_row_ = 0;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<std::unique_ptr<Tile>> tiles_;  ///< row-major; null where nothing was written
  std::size_t made_ = 0;
};

}  // namespace bw::slam
