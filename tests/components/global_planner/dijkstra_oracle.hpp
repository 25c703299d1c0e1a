// An independent answer to "what does the cheapest path cost": Dijkstra in doubles, distances by brute force.
#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <vector>

#include "components/global_planner/options.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::test {

class DijkstraOracle {
 public:
  DijkstraOracle(const OccupancyGrid& map, double robot_radius, const GlobalPlannerOptions& options)
      : map_(map) {
    // Cells farther than this cost 1, so nothing beyond matters.
    const double range = std::max(options.clearance_range, robot_radius) + map.resolution;
    const int reach = static_cast<int>(std::ceil(range / map.resolution)) + 1;
    for (int row = 0; row < map.height; ++row) {
      for (int column = 0; column < map.width; ++column) {
        double nearest = std::numeric_limits<double>::infinity();
        for (int r = std::max(row - reach, 0); r <= std::min(row + reach, map.height - 1); ++r) {
          for (int c = std::max(column - reach, 0); c <= std::min(column + reach, map.width - 1); ++c) {
            const std::int8_t value = map.at(c, r);
            const bool obstacle = value < 0 ? options.unknown_is_obstacle : value >= options.occupied_at;
            if (obstacle) nearest = std::min(nearest, std::hypot(c - column, r - row) * map.resolution);
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
          if (!free(c + dc, r + dr) || !free(c + dc, r) || !free(c, r + dr)) continue;
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
  double cost_of(double nearest, double robot_radius, const GlobalPlannerOptions& options) const {
    const double clearance = nearest - map_.resolution / 2.0;
    if (clearance < robot_radius) return 0.0;
    if (clearance >= options.clearance_range) return 1.0;
    const double closeness = (options.clearance_range - clearance) / (options.clearance_range - robot_radius);
    return 1.0 + options.clearance_weight * closeness * closeness;
  }

  const OccupancyGrid& map_;
  std::vector<double> cost_;
};

}  // namespace bw::test
