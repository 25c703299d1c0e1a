#include "components/localization/laser/pose_search_tables.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/localization/particle_filter/vector_clones.hpp"

namespace bw::localization {
namespace {

using Plane = std::vector<std::uint8_t>;

// Largest level whose squares are not wider than `step`.
int level_of(double step, double resolution) {
  int level = 0;
  while (level < 8 && resolution * (2 << level) <= step * 1.0001) ++level;
  return level;
}

// Maxima over squares of twice the edge from those over squares of `edge` cells.
Plane doubled(const Plane& from, std::int32_t width, std::int32_t height, std::int32_t edge) {
  Plane to(from.size());
  const auto at = [&](std::int32_t x, std::int32_t y) {
    return from[static_cast<std::size_t>(std::min(y, height - 1)) * static_cast<std::size_t>(width) +
                static_cast<std::size_t>(std::min(x, width - 1))];
  };
  std::size_t i = 0;
  for (std::int32_t y = 0; y < height; ++y) {
    for (std::int32_t x = 0; x < width; ++x) {
      to[i++] =
          std::max(std::max(at(x, y), at(x + edge, y)), std::max(at(x, y + edge), at(x + edge, y + edge)));
    }
  }
  return to;
}

BW_VECTOR_CLONES
void add_row(const std::int16_t* from, std::int32_t count, std::int16_t* to) {
  for (std::int32_t i = 0; i < count; ++i) to[i] = static_cast<std::int16_t>(to[i] + from[i]);
}

std::int32_t floor_divide(std::int32_t a, std::int32_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

}  // namespace

PoseSearchTables::PoseSearchTables(const LikelihoodField& field, double step, double clearance)
    : resolution_(field.resolution()), finest_(level_of(step, field.resolution())) {
  // A square that starts left of the table may reach into it: with this border none does.
  border_ = 2 << coarsest();
  width_ = field.width() + border_;
  height_ = field.height() + border_;
  origin_ = field.origin() - Vector2::Constant(border_ * resolution_);
  blocks_x_ = ((width_ - 1) >> coarsest()) + 1;
  blocks_y_ = ((height_ - 1) >> coarsest()) + 1;
  build_levels(field);
  build_free(field, clearance);
  build_phases();
}

void PoseSearchTables::build_levels(const LikelihoodField& field) {
  const LikelihoodFieldOptions& o = field.options();
  const double far = std::log(o.z_rand / o.kLaserMaxRange);
  const double scale = 255.0 / (std::log(o.z_hit + o.z_rand / o.kLaserMaxRange) - far);
  const auto value = [&](double log_p) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(scale * (log_p - far), 0.0, 255.0)));
  };
  const std::uint8_t outside = value(std::log(1.0 / o.kLaserMaxRange));
  outside_ = outside;
  const auto width = static_cast<std::size_t>(width_);
  levels_.resize(static_cast<std::size_t>(coarsest()) + 1);
  Plane plane(width * static_cast<std::size_t>(height_), outside);
  for (int row = 0; row < field.height(); ++row) {
    for (int column = 0; column < field.width(); ++column) {
      const auto from = static_cast<std::size_t>(row) * static_cast<std::size_t>(field.width()) +
                        static_cast<std::size_t>(column);
      const auto to =
          static_cast<std::size_t>(row + border_) * width + static_cast<std::size_t>(column + border_);
      plane[to] = value(static_cast<double>(field.log_table()[from]));
    }
  }
  levels_[0] = plane;
  for (int level = 1; level <= coarsest(); ++level) {
    plane = doubled(plane, width_, height_, 1 << (level - 1));
    if (level >= finest_) levels_[static_cast<std::size_t>(level)] = plane;
  }
}

void PoseSearchTables::build_free(const LikelihoodField& field, double clearance) {
  for (int level = finest_; level <= coarsest(); ++level) {
    FreeSquares squares;
    squares.width = ((width_ - 1) >> level) + 1;
    squares.height = ((height_ - 1) >> level) + 1;
    squares.any.resize(static_cast<std::size_t>(squares.width) * static_cast<std::size_t>(squares.height), 0);
    free_.push_back(squares);
  }
  for (std::int32_t y = border_; y < height_; ++y) {
    for (std::int32_t x = border_; x < width_; ++x) {
      const Vector2 p = center(x, y);
      const double d = field.distance(p.x(), p.y());
      if (!field.known(p.x(), p.y()) || d <= 0.0 || d < clearance) continue;
      for (int level = finest_; level <= coarsest(); ++level) {
        FreeSquares& squares = free_[static_cast<std::size_t>(level - finest_)];
        squares.any[static_cast<std::size_t>(y >> level) * static_cast<std::size_t>(squares.width) +
                    static_cast<std::size_t>(x >> level)] = 1;
      }
    }
  }
  for (std::uint32_t block = 0; block < free_.back().any.size(); ++block) {
    if (free_.back().any[block] != 0) free_blocks_.push_back(block);
  }
}

std::array<std::int32_t, 4> PoseSearchTables::sums(int level, std::int32_t x, std::int32_t y,
                                                   const CellOffsets& ends) const {
  std::array<std::int32_t, 4> sum{};
  const std::int32_t edge = 1 << level;
  const std::size_t count = ends.x.size();
  const bool inside = x + ends.least_x >= 0 && x + ends.most_x + edge < width_ && y + ends.least_y >= 0 &&
                      y + ends.most_y + edge < height_;
  if (!inside) {
    for (std::size_t b = 0; b < count; ++b) {
      const std::int32_t end_x = x + ends.x[b];
      const std::int32_t end_y = y + ends.y[b];
      sum[0] += at(level, end_x, end_y);
      sum[1] += at(level, end_x + edge, end_y);
      sum[2] += at(level, end_x, end_y + edge);
      sum[3] += at(level, end_x + edge, end_y + edge);
    }
    return sum;
  }
  const std::uint8_t* lower =
      levels_[static_cast<std::size_t>(level)].data() + static_cast<std::ptrdiff_t>(y) * width_ + x;
  const std::uint8_t* upper = lower + static_cast<std::ptrdiff_t>(edge) * width_;
  for (std::size_t b = 0; b < count; ++b) {
    const std::ptrdiff_t i = static_cast<std::ptrdiff_t>(ends.y[b]) * width_ + ends.x[b];
    sum[0] += lower[i];
    sum[1] += lower[i + edge];
    sum[2] += upper[i];
    sum[3] += upper[i + edge];
  }
  return sum;
}

void PoseSearchTables::build_phases() {
  // An end is rounded down to a multiple of stride_: the square it may reach is that much wider.
  stride_ = 1 << (coarsest() - 2);
  phase_width_ = (width_ - 1) / (4 * stride_) + 1;
  phase_height_ = (height_ - 1) / stride_ + 1;
  phases_.resize(4 * static_cast<std::size_t>(phase_width_) * static_cast<std::size_t>(phase_height_));
  std::size_t i = 0;
  const std::int32_t last = stride_ - 1;
  for (std::int32_t phase = 0; phase < 4; ++phase) {
    for (std::int32_t row = 0; row < phase_height_; ++row) {
      for (std::int32_t column = 0; column < phase_width_; ++column) {
        const std::int32_t x = (4 * column + phase) * stride_;
        const std::int32_t y = row * stride_;
        const std::int32_t value =
            std::max(std::max(at(coarsest(), x, y), at(coarsest(), x + last, y)),
                     std::max(at(coarsest(), x, y + last), at(coarsest(), x + last, y + last)));
        phases_[i++] = static_cast<std::int16_t>(value - outside_);
      }
    }
  }
}

void PoseSearchTables::add_bounds(std::int32_t x, std::int32_t y, std::vector<std::int16_t>& bounds) const {
  const std::int32_t k = floor_divide(x, stride_);
  const std::int32_t shift = floor_divide(k, 4);
  const std::int32_t phase = k - 4 * shift;
  const std::int32_t row_shift = floor_divide(y, stride_);
  const std::int32_t first = std::max(0, -shift);
  const std::int32_t last = std::min(blocks_x_, phase_width_ - shift);
  for (std::int32_t j = 0; j < blocks_y_; ++j) {
    std::int16_t* to = bounds.data() + static_cast<std::ptrdiff_t>(j) * blocks_x_;
    const std::int32_t row = 4 * j + row_shift;
    if (row >= 0 && row < phase_height_ && first < last) {
      const std::ptrdiff_t plane = static_cast<std::ptrdiff_t>(phase) * phase_height_ + row;
      add_row(phases_.data() + plane * phase_width_ + first + shift, last - first, to + first);
    }
  }
}

std::int32_t PoseSearchTables::column_of(double x) const {
  return static_cast<std::int32_t>(std::floor((x - origin_.x()) / resolution_));
}
std::int32_t PoseSearchTables::row_of(double y) const {
  return static_cast<std::int32_t>(std::floor((y - origin_.y()) / resolution_));
}

}  // namespace bw::localization
