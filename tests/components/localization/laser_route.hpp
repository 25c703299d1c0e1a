// Long drives through a map: from one random free position to the next by the shortest path, at constant
// speed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "components/model/differential_drive.hpp"
#include "components/model/distance_transform.hpp"
#include "components/model/occupancy_grid.hpp"
#include "components/model/random.hpp"

namespace bw::localization::test {

constexpr double kStepSeconds = 0.05;
constexpr double kSpeed = 0.52;  ///< [m/s]: 0.026 m a step, 0.26 m in ten

/// Free cells of a map, joined with each other, with room for a robot.
class Roads {
 public:
  explicit Roads(const OccupancyGrid& map, double clearance = 0.35) : map_(map) {
    const std::vector<float> distance = distance_field(map, {.unknown_is_obstacle = true});
    open_.resize(map.cells.size());
    for (std::size_t i = 0; i < open_.size(); ++i) {
      open_[i] = map.cells[i] >= 0 && static_cast<double>(distance[i]) >= clearance;
    }
    keep_largest_part();
  }

  const std::vector<std::size_t>& cells() const { return cells_; }
  Vector2 center(std::size_t cell) const {
    const auto width = static_cast<std::size_t>(map_.width);
    return map_.center(static_cast<int>(cell % width), static_cast<int>(cell / width));
  }
  std::size_t random_cell(Random& random) const { return cells_[random.bits() % cells_.size()]; }

  /// Cells from `from` to `to`, both included; few turns are not sought.
  std::vector<std::size_t> path(std::size_t from, std::size_t to) const {
    std::vector<std::size_t> parent = spread(to);  // backwards, so that following it goes forwards
    std::vector<std::size_t> cells{from};
    while (cells.back() != to) cells.push_back(parent[cells.back()]);
    return cells;
  }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  // Breadth first; straight neighbours before diagonal ones.
  std::vector<std::size_t> spread(std::size_t from) const {
    std::vector<std::size_t> parent(open_.size(), kNone);
    std::vector<std::size_t> queue{from};
    parent[from] = from;
    const auto width = static_cast<std::ptrdiff_t>(map_.width);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (const std::ptrdiff_t step : {std::ptrdiff_t{1}, std::ptrdiff_t{-1}, width, -width, width + 1,
                                        width - 1, -width + 1, -width - 1}) {
        const std::size_t next = queue[i] + static_cast<std::size_t>(step);
        if (next >= open_.size() || !open_[next] || parent[next] != kNone) continue;
        parent[next] = queue[i];
        queue.push_back(next);
      }
    }
    return parent;
  }

  void keep_largest_part() {
    std::vector<bool> seen(open_.size(), false);
    for (std::size_t cell = 0; cell < open_.size(); ++cell) {
      if (!open_[cell] || seen[cell]) continue;
      const std::vector<std::size_t> parent = spread(cell);
      std::vector<std::size_t> part;
      for (std::size_t i = 0; i < parent.size(); ++i) {
        if (parent[i] == kNone) continue;
        seen[i] = true;
        part.push_back(i);
      }
      if (part.size() > cells_.size()) cells_ = part;
    }
  }

  OccupancyGrid map_;
  std::vector<bool> open_;
  std::vector<std::size_t> cells_;
};

/// Poses of a robot at every step until it has driven `length` [m]. It aims at the path 0.4 m ahead, rotates
/// in place (2 rad/s) towards what lies more than a right angle off, else rotates at up to 1.5 rad/s.
inline std::vector<Pose2> route(const Roads& roads, Random& random, double length) {
  std::size_t start = roads.random_cell(random);
  std::vector<Vector2> points{roads.center(start)};
  Pose2 X{points[0].x(), points[0].y(), random.uniform(-3.0, 3.0)};
  std::vector<Pose2> poses{X};
  double driven = 0.0;
  std::size_t ahead = 0;
  while (driven < length) {
    while ((points[ahead] - X.position()).norm() < 0.4) {
      if (++ahead < points.size()) continue;
      const std::size_t goal = roads.random_cell(random);
      for (const std::size_t cell : roads.path(start, goal)) points.push_back(roads.center(cell));
      start = goal;
    }
    const Vector2 to = points[ahead] - X.position();
    const double off = wrap_angle(std::atan2(to.y(), to.x()) - X.theta);
    const bool in_place = std::abs(off) > 1.2;
    const double rate = in_place ? 2.0 : std::min(1.5, std::abs(off) / kStepSeconds * 0.3);
    const Twist2 twist{in_place ? 0.0 : kSpeed, std::copysign(rate, off)};
    X = advance_exact(X, twist, kStepSeconds);
    driven += twist.v * kStepSeconds;
    poses.push_back(X);
  }
  return poses;
}

}  // namespace bw::localization::test
