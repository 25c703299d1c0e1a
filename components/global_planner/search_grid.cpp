#include "components/global_planner/search_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "components/model/distance_transform.hpp"

namespace bw {
namespace {

constexpr double kTouch = 1e-3;  // [m] that a footprint may reach into an obstacle: positions are a grid's
constexpr double kTight =
    1e-2;  // [m] above the inscribed radius, below which the path between two positions is looked at

bool is_finite(const Capsule& c) { return c.a.allFinite() && c.b.allFinite() && std::isfinite(c.radius); }

std::uint16_t cell_cost(double clearance, double inscribed, const GlobalPlannerOptions& options) {
  if (clearance >= options.clearance_range) return kUnit;
  const double closeness =
      std::min(1.0, (options.clearance_range - clearance) / (options.clearance_range - inscribed));
  return static_cast<std::uint16_t>(
      std::lround(kUnit * (1.0 + options.clearance_weight * closeness * closeness)));
}

}  // namespace

void SearchGrid::build(const OccupancyGrid& map, const Footprint& footprint,
                       const GlobalPlannerOptions& options, const StaticObstacles& shapes) {
  resolution_ = map.resolution;
  origin_ = map.origin;
  footprint_ = footprint;
  inscribed_ = inscribed_radius(footprint);
  stride_ = map.width + 2;
  rows_ = map.height + 2;
  replaced_.clear();
  const std::size_t count = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows_);
  cells_.assign(count, {});
  clearance_.assign(count, 0.0F);
  narrow_.clear();
  narrow_cells_.clear();
  take_map(map, options);
  std::vector<Capsule> obstacles = outlines();
  for (const Capsule& shape : capsules_of(shapes)) {
    if (!is_finite(shape)) continue;
    take_shape(shape, std::max(options.clearance_range, footprint.radius));
    obstacles.push_back(shape);
  }
  obstacles_ = CapsuleIndex(std::move(obstacles));
  price(options);
  for (int y = 1; y < rows_ - 1; ++y) {
    for (int x = 1; x < stride_ - 1; ++x) set_moves(x, y);
  }
  label_components();
}

void SearchGrid::take_map(const OccupancyGrid& map, const GlobalPlannerOptions& options) {
  const ObstacleRule rule{.occupied_at = options.kOccupiedAt,
                          .unknown_is_obstacle = options.unknown_is_obstacle};
  const std::vector<float> distance = distance_field(map, rule);
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const double between_centers = distance[map.index(column, row)];
      // A robot smaller than half a cell still may not drive into an obstacle cell.
      clearance_[index(column + 1, row + 1)] =
          between_centers > 0.0 ? static_cast<float>(std::max(between_centers - resolution_ / 2.0, 0.0))
                                : -1.0F;
    }
  }
}

// Cells in a row or a column are one obstacle, so that a wall is as flat as it was. Those amid others are
// never the nearest.
std::vector<Capsule> SearchGrid::outlines() const {
  const int width = stride_ - 2, height = rows_ - 2;
  std::vector<Capsule> found;
  const auto is_solid = [&](int x, int y) { return clearance_[index(x, y)] < 0.0F; };
  const auto is_inner = [&](int x, int y) {
    return x > 1 && x < width && y > 1 && y < height && is_solid(x - 1, y) && is_solid(x + 1, y) &&
           is_solid(x, y - 1) && is_solid(x, y + 1);
  };
  const auto is_outline = [&](int x, int y) { return is_solid(x, y) && !is_inner(x, y); };
  const auto add = [&](int x0, int y0, int x1, int y1) {
    found.push_back({center(x0, y0), center(x1, y1), resolution_ / 2.0});
  };
  for (int y = 1; y <= height; ++y) {
    for (int x = 1; x <= width; ++x) {
      if (!is_outline(x, y)) continue;
      const int from = x;
      while (x < width && is_outline(x + 1, y)) ++x;
      const bool stands_in_a_column = (y > 1 && is_outline(x, y - 1)) || (y < height && is_outline(x, y + 1));
      if (from < x || !stands_in_a_column) add(from, y, x, y);
    }
  }
  for (int x = 1; x <= width; ++x) {
    for (int y = 1; y <= height; ++y) {
      if (!is_outline(x, y)) continue;
      const int from = y;
      while (y < height && is_outline(x, y + 1)) ++y;
      if (from < y) add(x, from, x, y);
    }
  }
  return found;
}

void SearchGrid::take_shape(const Capsule& shape, double range) {
  const auto clamped = [](double value, int high) {
    return static_cast<int>(std::clamp(std::floor(value), 1.0, static_cast<double>(high)));
  };
  const Vector2 reach = Vector2::Constant(shape.radius + range);
  const Vector2 low = to_cells(shape.a.cwiseMin(shape.b) - reach);
  const Vector2 high = to_cells(shape.a.cwiseMax(shape.b) + reach);
  const int x1 = clamped(high.x(), stride_ - 2);
  const int y1 = clamped(high.y(), rows_ - 2);
  for (int y = clamped(low.y(), rows_ - 2); y <= y1; ++y) {
    for (int x = clamped(low.x(), stride_ - 2); x <= x1; ++x) {
      float& clearance = clearance_[index(x, y)];
      clearance = std::min(clearance, static_cast<float>(distance_to(center(x, y), shape).distance));
    }
  }
}

void SearchGrid::find(const Vector2& point, double reach, std::vector<Capsule>& found) const {
  obstacles_.visit_near(point, reach, [&](const CapsuleIndex::Group& group) {
    for (const std::uint32_t i : obstacles_.members(group)) {
      const Capsule& obstacle = obstacles_.capsules()[i];
      if (distance_to(point, obstacle).distance <= reach) found.push_back(obstacle);
    }
  });
}

// Cells whose middle is far enough are free; of those where the footprint may just fit, position and headings
// are looked at.
void SearchGrid::price(const GlobalPlannerOptions& options) {
  const double to_corner = resolution_ * std::numbers::sqrt2 / 2.0;
  const bool is_polygon = footprint_.is_polygon();
  max_cost_ = kUnit;
  for (int y = 1; y < rows_ - 1; ++y) {
    for (int x = 1; x < stride_ - 1; ++x) {
      const std::size_t i = index(x, y);
      double clearance = clearance_[i];
      clearance_[i] = std::max(clearance_[i], 0.0F);
      if (clearance < 0.0 || clearance + to_corner < inscribed_) continue;
      if (clearance < (is_polygon ? footprint_.radius : inscribed_)) {
        NarrowCell cell{.position = center(x, y), .clearance = clearance};
        if (!look_closely(x, y, cell)) continue;
        if (narrow_.empty()) narrow_.assign(cells_.size(), 0);
        narrow_cells_.push_back(cell);
        narrow_[i] = static_cast<std::uint32_t>(narrow_cells_.size());
        clearance = cell.clearance;
      }
      cells_[i].cost = cell_cost(clearance, inscribed_, options);
      max_cost_ = std::max<std::uint32_t>(max_cost_, cells_[i].cost);
    }
  }
}

// False where the footprint fits nowhere in the cell.
bool SearchGrid::look_closely(int x, int y, NarrowCell& cell) const {
  std::vector<Capsule> near;
  const double to_corner = resolution_ * std::numbers::sqrt2 / 2.0;
  // From a position in the cell: the nearest of all, and those that the footprint may touch.
  find(cell.position, std::max(cell.clearance + to_corner, footprint_.radius) + to_corner, near);
  // Elsewhere in the cell a position may be better by no more than the distance there.
  if (cell.clearance < inscribed_ + to_corner) cell = best_position(center(x, y), resolution_, near);
  if (cell.clearance < inscribed_) return false;
  if (footprint_.is_polygon()) cell.headings = free_headings(footprint_, cell.position, near);
  return cell.headings != 0;
}

bool SearchGrid::fits(const Pose2& pose) const {
  std::vector<Capsule> near;
  find(pose.position(), footprint_.radius, near);
  return std::ranges::all_of(
      near, [&](const Capsule& obstacle) { return gap_to(footprint_, pose, obstacle, 0.0) >= -kTouch; });
}

bool SearchGrid::holds(const Vector2& position) const {
  std::vector<Capsule> near;
  find(position, inscribed_ - kTouch, near);
  return near.empty();
}

bool SearchGrid::may_step(int x, int y, const GridStep& s) const {
  if (!free(x + s.dx, y + s.dy)) return false;
  const NarrowCell* from = narrow(x, y);
  const NarrowCell* to = narrow(x + s.dx, y + s.dy);
  // A diagonal step also needs both cells beside it: no cutting of corners.
  const bool is_straight = free(x + s.dx, y) && free(x, y + s.dy);
  if (from == nullptr && to == nullptr) return is_straight;
  const Vector2 a = position(x, y);
  const Vector2 offset = position(x + s.dx, y + s.dy) - a;
  const std::uint64_t common =
      (from == nullptr ? kAllHeadings : from->headings) & (to == nullptr ? kAllHeadings : to->headings);
  if ((common & headings_along(std::atan2(offset.y(), offset.x()))) == 0) return false;
  // Between two positions that just fit an obstacle may reach further in.
  const auto is_tight = [this](const NarrowCell* cell) {
    return cell != nullptr && cell->clearance < inscribed_ + kTight;
  };
  if (is_straight && !is_tight(from) && !is_tight(to)) return true;
  return holds(a + offset / 2.0);
}

void SearchGrid::set_moves(int x, int y) {
  SearchCell& cell = cells_[index(x, y)];
  cell.moves = 0;
  if (cell.cost == 0) return;
  for (unsigned d = 0; d < 8; ++d) {
    if (may_step(x, y, kSteps[d])) cell.moves = static_cast<std::uint8_t>(cell.moves | (1u << d));
  }
}

void SearchGrid::label_components() {
  constexpr std::uint32_t kUnlabelled = 0;
  component_.assign(cells_.size(), kUnlabelled);
  std::uint32_t label = kUnlabelled;
  std::vector<std::size_t> open;
  std::ptrdiff_t offset[8];
  for (unsigned d = 0; d < 8; ++d)
    offset[d] = static_cast<std::ptrdiff_t>(kSteps[d].dy) * stride_ + kSteps[d].dx;
  for (std::size_t seed = 0; seed < cells_.size(); ++seed) {
    if (cells_[seed].cost == 0 || component_[seed] != kUnlabelled) continue;
    component_[seed] = ++label;
    open.push_back(seed);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      // A step that is allowed is allowed back.
      for (unsigned moves = cells_[i].moves; moves != 0; moves &= moves - 1) {
        const std::size_t n =
            static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + offset[__builtin_ctz(moves)]);
        if (component_[n] != kUnlabelled) continue;
        component_[n] = label;
        open.push_back(n);
      }
    }
  }
}

bool SearchGrid::on_map(const Vector2& p) const {
  const Vector2 c = to_cells(p);
  return c.x() >= 1.0 && c.y() >= 1.0 && c.x() < stride_ - 1.0 && c.y() < rows_ - 1.0;
}

std::pair<int, int> SearchGrid::cell_of(const Vector2& p) const {
  const Vector2 c = to_cells(p);
  return {static_cast<int>(c.x()), static_cast<int>(c.y())};
}

void SearchGrid::block(const std::vector<Disc>& discs) {
  for (const Disc& disc : discs) {
    const double reach = (disc.radius + footprint_.radius) / resolution_;
    const Vector2 c = to_cells(disc.center);
    const auto clamped = [](double value, int high) {
      return static_cast<int>(std::clamp(std::floor(value), 1.0, static_cast<double>(high)));
    };
    // One cell more than the disc, because the moves of the cells around it change too.
    const int x0 = clamped(c.x() - reach - 1.0, stride_ - 1);
    const int y0 = clamped(c.y() - reach - 1.0, rows_ - 1);
    const int x1 = clamped(c.x() + reach + 2.0, stride_ - 1);
    const int y1 = clamped(c.y() + reach + 2.0, rows_ - 1);
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) replaced_.emplace_back(index(x, y), cells_[index(x, y)]);
    }
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) {
        const double dx = x + 0.5 - c.x();
        const double dy = y + 0.5 - c.y();
        if (dx * dx + dy * dy < reach * reach) cells_[index(x, y)].cost = 0;
      }
    }
    for (int y = y0; y < y1; ++y) {
      for (int x = x0; x < x1; ++x) set_moves(x, y);
    }
  }
}

void SearchGrid::unblock() {
  // Backwards, because discs may overlap.
  for (; !replaced_.empty(); replaced_.pop_back()) {
    const auto& [i, cell] = replaced_.back();
    cells_[i].cost = cell.cost;
    cells_[i].moves = cell.moves;
  }
}

}  // namespace bw
