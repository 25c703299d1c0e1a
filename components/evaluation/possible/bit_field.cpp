#include "components/evaluation/possible/bit_field.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace bw::possible {
namespace {

/// row |= row moved up by `bits`, 1 to 63.
void or_moved_up(std::vector<std::uint64_t>& row, int bits) {
  for (std::size_t w = row.size(); w-- > 0;) {
    const std::uint64_t carried = w > 0 ? row[w - 1] >> (64 - bits) : 0;
    row[w] |= row[w] << bits | carried;
  }
}

}  // namespace

BitField::BitField(int side)
    : side_(side),
      stride_((side + 63) / 64),
      words_(static_cast<std::size_t>(side) * static_cast<std::size_t>(stride_)) {}

void BitField::clear() {
  for (int row = low_row_; row <= high_row_; ++row)
    std::fill(row_of(row) + low_word_, row_of(row) + high_word_ + 1, 0);
  low_row_ = low_word_ = 0;
  high_row_ = high_word_ = -1;
}

void BitField::set(int row, Run columns) {
  const int first = std::max(columns.first, 0);
  const int last = std::min(columns.last, side_ - 1);
  if (row < 0 || row >= side_ || last < first) return;
  std::uint64_t* words = row_of(row);
  for (int word = first / 64; word <= last / 64; ++word) {
    std::uint64_t bits = ~std::uint64_t{0};
    if (word == first / 64) bits &= ~std::uint64_t{0} << (first % 64);
    if (word == last / 64) bits &= ~std::uint64_t{0} >> (63 - last % 64);
    words[word] |= bits;
  }
  if (empty()) {
    low_row_ = high_row_ = row;
    low_word_ = first / 64;
    high_word_ = last / 64;
    return;
  }
  low_row_ = std::min(low_row_, row);
  high_row_ = std::max(high_row_, row);
  low_word_ = std::min(low_word_, first / 64);
  high_word_ = std::max(high_word_, last / 64);
}

bool BitField::add_moved(const BitField& other, int rows, Run columns) {
  if (other.empty()) return true;
  const auto words_for = [](int bits) { return (bits + 63) / 64; };
  // The moved row spans the words of the other one and as many on both sides as its move takes.
  const int below = words_for(std::max(0, -columns.first)) + 1;
  const int above = words_for(std::max(0, columns.last)) + 1;
  const int base = other.low_word_ - below;
  std::vector<std::uint64_t> moved(
      static_cast<std::size_t>(other.high_word_ - other.low_word_ + 1 + below + above));
  const int length = columns.last - columns.first + 1;
  const int first_word = std::max(0, base);
  const int last_word = std::min(stride_ - 1, base + static_cast<int>(moved.size()) - 1);
  const std::uint64_t beyond = side_ % 64 == 0 ? 0 : ~std::uint64_t{0} << (side_ % 64);
  bool all_inside = true;
  int low = high_row_ < low_row_ ? side_ : low_row_;
  int high = high_row_;
  bool has_any = false;
  for (int row = other.low_row_; row <= other.high_row_; ++row) {
    const std::uint64_t* source = other.row_of(row);
    std::fill(moved.begin(), moved.end(), 0);
    std::uint64_t any = 0;
    // By columns.first: whole words, then bits.
    const int whole = static_cast<int>(std::floor(columns.first / 64.0));
    const int bits = columns.first - 64 * whole;
    for (int w = other.low_word_; w <= other.high_word_; ++w) {
      const std::uint64_t value = source[w];
      if (value == 0) continue;
      any |= value;
      const auto at = static_cast<std::size_t>(w - base + whole);
      moved[at] |= value << bits;
      if (bits > 0) moved[at + 1] |= value >> (64 - bits);
    }
    if (any == 0) continue;
    for (int have = 1; have < length;) {
      const int step = std::min({have, length - have, 63});
      or_moved_up(moved, step);
      have += step;
    }
    const int to = row + rows;
    if (to < 0 || to >= side_) {
      all_inside = false;
      continue;
    }
    std::uint64_t* target = row_of(to);
    for (int w = first_word; w <= last_word; ++w) target[w] |= moved[static_cast<std::size_t>(w - base)];
    for (int w = base; w < base + static_cast<int>(moved.size()); ++w)
      if ((w < 0 || w >= stride_) && moved[static_cast<std::size_t>(w - base)] != 0) all_inside = false;
    if (beyond != 0 && last_word == stride_ - 1 && (target[stride_ - 1] & beyond) != 0) {
      target[stride_ - 1] &= ~beyond;
      all_inside = false;
    }
    low = std::min(low, to);
    high = std::max(high, to);
    has_any = true;
  }
  if (!has_any) return all_inside;
  const bool was_empty = empty();
  low_row_ = low;
  high_row_ = high;
  low_word_ = was_empty ? first_word : std::min(low_word_, first_word);
  high_word_ = was_empty ? last_word : std::max(high_word_, last_word);
  return all_inside;
}

void BitField::keep(const BitField& allowed) {
  for (int row = low_row_; row <= high_row_; ++row) {
    std::uint64_t* words = row_of(row);
    const std::uint64_t* mask = allowed.row_of(row);
    for (int w = low_word_; w <= high_word_; ++w) words[w] &= mask[w];
  }
  shrink();
}

void BitField::remove(const BitField& other) {
  for (int row = std::max(low_row_, other.low_row_); row <= std::min(high_row_, other.high_row_); ++row) {
    std::uint64_t* words = row_of(row);
    const std::uint64_t* mask = other.row_of(row);
    for (int w = std::max(low_word_, other.low_word_); w <= std::min(high_word_, other.high_word_); ++w)
      words[w] &= ~mask[w];
  }
  shrink();
}

std::int64_t BitField::count() const {
  std::int64_t sum = 0;
  for (int row = low_row_; row <= high_row_; ++row)
    for (int w = low_word_; w <= high_word_; ++w) sum += std::popcount(row_of(row)[w]);
  return sum;
}

void BitField::shrink() {
  if (empty()) return;
  int low_row = side_;
  int high_row = -1;
  int low_word = stride_;
  int high_word = -1;
  for (int row = low_row_; row <= high_row_; ++row) {
    for (int w = low_word_; w <= high_word_; ++w) {
      if (row_of(row)[w] == 0) continue;
      low_row = std::min(low_row, row);
      high_row = row;
      low_word = std::min(low_word, w);
      high_word = std::max(high_word, w);
    }
  }
  low_row_ = high_row < 0 ? 0 : low_row;
  high_row_ = high_row;
  low_word_ = high_word < 0 ? 0 : low_word;
  high_word_ = high_word;
}

void paint(BitField& field, const BitFrame& frame, const Vector2& a, const Vector2& b, double radius) {
  if (radius <= 0.0) return;
  const Vector2 along = b - a;
  const double squared = along.squaredNorm();
  const auto index = [&](double value, double center) {
    return std::clamp((value - center) / frame.cell, -1e6, 1e6) + frame.side / 2;
  };
  const int low =
      std::max(0, static_cast<int>(std::ceil(index(std::min(a.y(), b.y()) - radius, frame.center.y()))));
  const int high = std::min(
      frame.side - 1, static_cast<int>(std::floor(index(std::max(a.y(), b.y()) + radius, frame.center.y()))));
  const int left =
      std::max(0, static_cast<int>(std::ceil(index(std::min(a.x(), b.x()) - radius, frame.center.x()))));
  const int right = std::min(
      frame.side - 1, static_cast<int>(std::floor(index(std::max(a.x(), b.x()) + radius, frame.center.x()))));
  for (int row = low; row <= high; ++row) {
    if (squared == 0.0) {  // a disc: one run
      const double dy = frame.y_of(row) - a.y();
      const double half = std::sqrt(std::max(0.0, radius * radius - dy * dy));
      field.set(row, {static_cast<int>(std::ceil(index(a.x() - half, frame.center.x()))),
                      static_cast<int>(std::floor(index(a.x() + half, frame.center.x())))});
      continue;
    }
    // A capsule is convex: what it holds of a row is one run.
    Run run{right + 1, left - 1};
    for (int column = left; column <= right; ++column) {
      const Vector2 p{frame.x_of(column), frame.y_of(row)};
      const double s = std::clamp((p - a).dot(along) / squared, 0.0, 1.0);
      if ((p - a - s * along).squaredNorm() > radius * radius) continue;
      run.first = std::min(run.first, column);
      run.last = std::max(run.last, column);
    }
    field.set(row, run);
  }
}

}  // namespace bw::possible
