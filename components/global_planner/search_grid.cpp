#include "components/global_planner/search_grid.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/distance_transform.hpp"

namespace bw {
namespace {

std::uint16_t cell_cost(double clearance, double robot_radius, const GlobalPlannerOptions& options) {
  if (clearance < robot_radius) return 0;
  if (clearance >= options.clearance_range) return kUnit;
  const double closeness = (options.clearance_range - clearance) / (options.clearance_range - robot_radius);
  return static_cast<std::uint16_t>(
      std::lround(kUnit * (1.0 + options.clearance_weight * closeness * closeness)));
}

}  // namespace

void SearchGrid::build(const OccupancyGrid& map, double robot_radius, const GlobalPlannerOptions& options) {
  resolution_ = map.resolution;
  origin_ = map.origin;
  robot_radius_ = robot_radius;
  stride_ = map.width + 2;
  rows_ = map.height + 2;
  replaced_.clear();
  const std::size_t count = static_cast<std::size_t>(stride_) * static_cast<std::size_t>(rows_);
  cells_.assign(count, {});
  clearance_.assign(count, 0.0F);
  const std::vector<float> distance = distance_field(
      map, {.occupied_at = options.occupied_at, .unknown_is_obstacle = options.unknown_is_obstacle});
  max_cost_ = kUnit;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      const double between_centers = distance[map.index(column, row)];
      const double clearance = std::max(between_centers - resolution_ / 2.0, 0.0);
      const std::size_t i = index(column + 1, row + 1);
      clearance_[i] = static_cast<float>(clearance);
      // A robot smaller than half a cell still may not drive into an obstacle cell.
      cells_[i].cost = between_centers > 0.0 ? cell_cost(clearance, robot_radius, options) : std::uint16_t{0};
      max_cost_ = std::max<std::uint32_t>(max_cost_, cells_[i].cost);
    }
  }
  for (int y = 1; y < rows_ - 1; ++y) {
    for (int x = 1; x < stride_ - 1; ++x) set_moves(x, y);
  }
  label_components();
}

void SearchGrid::set_moves(int x, int y) {
  SearchCell& cell = cells_[index(x, y)];
  cell.moves = 0;
  if (cell.cost == 0) return;
  for (unsigned d = 0; d < 8; ++d) {
    const GridStep& s = kSteps[d];
    // A diagonal step also needs both cells beside it: no cutting of corners.
    if (free(x + s.dx, y + s.dy) && free(x + s.dx, y) && free(x, y + s.dy)) {
      cell.moves = static_cast<std::uint8_t>(cell.moves | (1u << d));
    }
  }
}

void SearchGrid::label_components() {
  constexpr std::uint32_t kUnlabelled = 0;
  component_.assign(cells_.size(), kUnlabelled);
  std::uint32_t label = kUnlabelled;
  std::vector<std::size_t> open;
  const auto stride = static_cast<std::size_t>(stride_);
  for (std::size_t seed = 0; seed < cells_.size(); ++seed) {
    if (cells_[seed].cost == 0 || component_[seed] != kUnlabelled) continue;
    component_[seed] = ++label;
    open.push_back(seed);
    while (!open.empty()) {
      const std::size_t i = open.back();
      open.pop_back();
      // Straight steps suffice: a diagonal one is allowed only where two straight ones are.
      for (const std::size_t n : {i + 1, i - 1, i + stride, i - stride}) {
        if (cells_[n].cost == 0 || component_[n] != kUnlabelled) continue;
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
    const double reach = (disc.radius + robot_radius_) / resolution_;
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
