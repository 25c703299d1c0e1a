#include "components/slam/max_grids.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bw::slam {
namespace {

constexpr int kKernelReach = 3;  // [cells] of a wall's likelihood

int cell_of(float v) { return static_cast<int>(std::floor(static_cast<double>(v) / MaxGrids::kCell)); }

}  // namespace

MaxGrids::MaxGrids(std::span<const Surface> all) {
  std::vector<Surface> surfaces;
  std::copy_if(all.begin(), all.end(), std::back_inserter(surfaces),
               [](const Surface& s) { return std::hypot(s.x, s.y) <= static_cast<float>(kReach); });
  if (surfaces.empty()) return;
  int last_column = -1000000;
  int last_row = -1000000;
  first_column_ = 1000000;
  first_row_ = 1000000;
  for (const Surface& s : surfaces) {
    first_column_ = std::min(first_column_, cell_of(s.x));
    last_column = std::max(last_column, cell_of(s.x));
    first_row_ = std::min(first_row_, cell_of(s.y));
    last_row = std::max(last_row, cell_of(s.y));
  }
  // A square that begins left of the walls may reach them.
  const int margin = (1 << (kLevels - 1)) + kKernelReach;
  first_column_ -= margin;
  first_row_ -= margin;
  columns_ = last_column + kKernelReach + 1 - first_column_;
  rows_ = last_row + kKernelReach + 1 - first_row_;
  const auto width = static_cast<std::size_t>(columns_);
  levels_.assign(kLevels, std::vector<std::uint8_t>(width * static_cast<std::size_t>(rows_), 0));
  for (const Surface& s : surfaces) {
    const int i0 = cell_of(s.x);
    const int j0 = cell_of(s.y);
    for (int j = j0 - kKernelReach; j <= j0 + kKernelReach; ++j) {
      for (int i = i0 - kKernelReach; i <= i0 + kKernelReach; ++i) {
        const double dx = (i + 0.5) * kCell - static_cast<double>(s.x);
        const double dy = (j + 0.5) * kCell - static_cast<double>(s.y);
        const auto value = static_cast<std::uint8_t>(
            255.0 * std::exp(-(dx * dx + dy * dy) / (2.0 * kSpread * kSpread)) + 0.5);
        std::uint8_t& cell = levels_[0][static_cast<std::size_t>(j - first_row_) * width +
                                        static_cast<std::size_t>(i - first_column_)];
        cell = std::max(cell, value);
      }
    }
  }
  // Twice the edge: the largest of four squares of half of it.
  for (std::size_t level = 1; level < levels_.size(); ++level) {
    const std::vector<std::uint8_t>& half = levels_[level - 1];
    const std::size_t shift = std::size_t{1} << (level - 1);
    const auto height = static_cast<std::size_t>(rows_);
    std::vector<std::uint8_t> across(half.size());
    for (std::size_t row = 0; row < height; ++row)
      for (std::size_t column = 0; column < width; ++column) {
        const std::size_t at = row * width + column;
        across[at] = column + shift < width ? std::max(half[at], half[at + shift]) : half[at];
      }
    for (std::size_t row = 0; row < height; ++row)
      for (std::size_t column = 0; column < width; ++column) {
        const std::size_t at = row * width + column;
        levels_[level][at] =
            row + shift < height ? std::max(across[at], across[at + shift * width]) : across[at];
      }
  }
}

}  // namespace bw::slam
