// A plane of square cells, one bit each, and what searches do with such planes.
#pragma once

#include <cstdint>
#include <vector>

#include "components/model/obstacles.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::possible {

/// Where cells are: `side` x `side` of edge `cell` [m] around `center`, which is the middle of a cell.
struct BitFrame {
  Vector2 center{0.0, 0.0};
  double cell = 0.01;
  int side = 1;

  double x_of(int column) const { return center.x() + (column - side / 2) * cell; }
  double y_of(int row) const { return center.y() + (row - side / 2) * cell; }
  int column_of(double x) const { return static_cast<int>(std::lround((x - center.x()) / cell)) + side / 2; }
  int row_of(double y) const { return static_cast<int>(std::lround((y - center.y()) / cell)) + side / 2; }
  bool contains(int column, int row) const { return column >= 0 && row >= 0 && column < side && row < side; }
};

/// Columns from `first` to `last`, both included; none when last < first.
struct Run {
  int first = 0;
  int last = -1;
};

class BitField {
 public:
  explicit BitField(int side = 0);

  int side() const { return side_; }
  bool empty() const { return high_row_ < low_row_; }
  bool at(int column, int row) const { return (row_of(row)[column / 64] >> (column % 64) & 1U) != 0; }
  void clear();
  void set(int row, Run columns);
  /// Adds `other`, moved by `rows` and by each of `columns`. False when something would leave the field; it
  /// is left out then.
  bool add_moved(const BitField& other, int rows, Run columns);
  void add(const BitField& other) { add_moved(other, 0, {0, 0}); }
  /// Keeps what is in `allowed`.
  void keep(const BitField& allowed);
  /// Takes away what is in `other`.
  void remove(const BitField& other);
  std::int64_t count() const;

 private:
  std::uint64_t* row_of(int row) { return words_.data() + static_cast<std::ptrdiff_t>(row) * stride_; }
  const std::uint64_t* row_of(int row) const {
    return words_.data() + static_cast<std::ptrdiff_t>(row) * stride_;
  }
  /// Rows and words outside of these are zero.
  void shrink();

  int side_ = 0;
  int stride_ = 0;  ///< words of a row
  std::vector<std::uint64_t> words_;
  int low_row_ = 0, high_row_ = -1;
  int low_word_ = 0, high_word_ = -1;
};

/// Adds all cells whose centre is within `radius` of the segment a-b [m].
void paint(BitField& field, const BitFrame& frame, const Vector2& a, const Vector2& b, double radius);

}  // namespace bw::possible
