// An independent answer to "what does the cheapest path cost": Dijkstra in doubles, distances by brute force.
// Of narrow cells it takes the grid's word for the position, and checks the clearance there.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "components/global_planner/search_grid.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::test {

class DijkstraOracle {
 public:
  DijkstraOracle(const OccupancyGrid& map, double robot_radius, const GlobalPlannerOptions& options,
                 const SearchGrid& grid)
      : map_(map), grid_(grid) {
    // Cells farther than this cost 1, so nothing beyond matters.
    const double range = std::max(options.clearance_range, robot_radius) + map.resolution;
    const int reach = static_cast<int>(std::ceil(range / map.resolution)) + 1;
    for (int row = 0; row < map.height; ++row) {
      for (int column = 0; column < map.width; ++column) {
        const NarrowCell* narrow = grid.narrow(column + 1, row + 1);
        const Vector2 from = narrow == nullptr ? map.center(column, row) : narrow->position;
        double nearest = std::numeric_limits<double>::infinity();
        for (int r = std::max(row - reach, 0); r <= std::min(row + reach, map.height - 1); ++r) {
          for (int c = std::max(column - reach, 0); c <= std::min(column + reach, map.width - 1); ++c) {
            const std::int8_t value = map.at(c, r);
            const bool obstacle = value < 0 ? options.unknown_is_obstacle : value >= options.kOccupiedAt;
            if (!obstacle) continue;
            nearest = std::min(nearest, (map.center(c, r) - from).norm());
            if (narrow != nullptr) nearest = std::min(nearest, distance_to_joints(c, r, from, options));
          }
        }
        cost_.push_back(cost_of(nearest, robot_radius, options));
      }
    }
  }

  bool free(int column, int row) const {
    return map_.contains(column, row) && cost_[map_.index(column, row)] > 0.0;
  }

  /// In free metres; infinity when there is no path.
  double cost(int column0, int row0, int column1, int row1) const {
    std::vector<double> best(cost_.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, std::pair<int, int>>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    best[map_.index(column0, row0)] = 0.0;
    open.push({0.0, {column0, row0}});
    while (!open.empty()) {
      const auto [d, cell] = open.top();
      open.pop();
      const auto [c, r] = cell;
      if (d > best[map_.index(c, r)]) continue;
      if (c == column1 && r == row1) return d;
      for (int dr = -1; dr <= 1; ++dr) {
        for (int dc = -1; dc <= 1; ++dc) {
          if (!joined(c, r, dc, dr)) continue;
          const std::size_t i = map_.index(c + dc, r + dr);
          const double next = d + std::hypot(dc, dr) * map_.resolution * cost_[i];
          if (next >= best[i]) continue;
          best[i] = next;
          open.push({next, {c + dc, r + dr}});
        }
      }
    }
    return std::numeric_limits<double>::infinity();
  }

 private:
  bool joined(int c, int r, int dc, int dr) const {
    if (!free(c + dc, r + dr)) return false;
    const auto is_narrow = [this](int x, int y) { return grid_.narrow(x + 1, y + 1) != nullptr; };
    if (!is_narrow(c, r) && !is_narrow(c + dc, r + dr)) return free(c + dc, r) && free(c, r + dr);
    for (unsigned d = 0; d < 8; ++d) {
      if (kSteps[d].dx == dc && kSteps[d].dy == dr)
        return (grid_.cells()[grid_.index(c + 1, r + 1)].moves >> d & 1u) != 0;
    }
    return false;
  }

  // Neighbouring obstacle cells are joined: to the lines between their middles.
  double distance_to_joints(int c, int r, const Vector2& from, const GlobalPlannerOptions& options) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [dc, dr] : {std::pair{1, 0}, {0, 1}}) {
      if (!map_.contains(c + dc, r + dr)) continue;
      const std::int8_t value = map_.at(c + dc, r + dr);
      if (!(value < 0 ? options.unknown_is_obstacle : value >= options.kOccupiedAt)) continue;
      const Vector2 a = map_.center(c, r);
      const Vector2 step = map_.center(c + dc, r + dr) - a;
      const double share = std::clamp((from - a).dot(step) / step.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (from - a - share * step).norm());
    }
    return nearest;
  }

  double cost_of(double nearest, double robot_radius, const GlobalPlannerOptions& options) const {
    const double clearance = nearest - map_.resolution / 2.0;
    if (nearest == 0.0 || clearance < robot_radius - 1e-9) return 0.0;
    if (clearance >= options.clearance_range) return 1.0;
    const double closeness = (options.clearance_range - clearance) / (options.clearance_range - robot_radius);
    return 1.0 + options.clearance_weight * closeness * closeness;
  }

  const OccupancyGrid& map_;
  const SearchGrid& grid_;
  std::vector<double> cost_;
};

}  // namespace bw::test
