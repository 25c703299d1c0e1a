#include "components/explore/frontier_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <utility>

#include "components/model/distance_transform.hpp"

namespace bw::explore {
namespace {

constexpr ObstacleRule kOccupied{.unknown_is_obstacle = false};
constexpr ObstacleRule kNotKnownFree{.unknown_is_obstacle = true};
constexpr double kBeside = 0.5;   // [m] from a robot that stands where it does not fit to where it does
constexpr double kLooksIn = 1.5;  // [m] from a goal to its frontier, along cells
constexpr double kNever = std::numeric_limits<double>::infinity();

struct Cell {
  int column = 0;
  int row = 0;
};

template <class Each>
void for_neighbours(const OccupancyGrid& map, Cell at, Each each) {
  for (int row = std::max(0, at.row - 1); row <= std::min(map.height - 1, at.row + 1); ++row)
    for (int column = std::max(0, at.column - 1); column <= std::min(map.width - 1, at.column + 1); ++column)
      if (row != at.row || column != at.column) each(Cell{column, row});
}

class Search {
 public:
  Search(const OccupancyGrid& map, const FrontierOptions& options)
      : map_(map),
        options_(options),
        from_walls_(distance_field(map, kOccupied)),
        from_unknown_(distance_field(map, kNotKnownFree)) {
    // Distances are between centres of cells, an obstacle is as large as its cell.
    clearance_ = options.radius + 0.75 * map.resolution;
  }

  FrontierSearch run(const Vector2& robot) {
    FrontierSearch result;
    const std::optional<Cell> start = beside(robot, from_walls_);
    if (!start) return result;
    result.is_placed = true;
    flood(*start);
    to_frontier_.assign(map_.cells.size(), kNever);
    if (const std::optional<Cell> safe = beside(robot, from_unknown_)) measure_paths(*safe);
    std::vector<bool> taken(map_.cells.size(), false);
    for (int row = 0; row < map_.height; ++row)
      for (int column = 0; column < map_.width; ++column)
        if (const Cell cell{column, row}; is_frontier(cell) && !taken[index(cell)])
          add(cluster(cell, taken), result);
    std::ranges::sort(result.frontiers, [](const Frontier& a, const Frontier& b) {
      if (a.path_length != b.path_length) return a.path_length < b.path_length;
      return std::pair(a.centre.x(), a.centre.y()) < std::pair(b.centre.x(), b.centre.y());
    });
    return result;
  }

 private:
  std::size_t index(Cell c) const { return map_.index(c.column, c.row); }
  bool is_known_free(Cell c) const {
    const std::int8_t value = map_.at(c.column, c.row);
    return value >= 0 && !kOccupied.blocks(value);
  }
  bool fits(Cell c, const std::vector<float>& distance) const {
    return is_known_free(c) && static_cast<double>(distance[index(c)]) >= clearance_;
  }

  // The cell nearest to a position where the robot fits.
  std::optional<Cell> beside(const Vector2& position, const std::vector<float>& distance) const {
    const int reach = static_cast<int>(std::ceil(kBeside / map_.resolution));
    const Cell at{map_.column_of(position.x()), map_.row_of(position.y())};
    std::optional<Cell> best;
    double nearest = kBeside;
    for (int row = std::max(0, at.row - reach); row <= std::min(map_.height - 1, at.row + reach); ++row)
      for (int column = std::max(0, at.column - reach); column <= std::min(map_.width - 1, at.column + reach);
           ++column) {
        const double away = (map_.center(column, row) - position).norm();
        if (away > nearest || (best && away == nearest) || !fits({column, row}, distance)) continue;
        nearest = away;
        best = Cell{column, row};
      }
    return best;
  }

  // All that is joined with `start` where the robot fits, as far as obstacles are known.
  void flood(Cell start) {
    joined_.assign(map_.cells.size(), false);
    std::deque<Cell> open{start};
    joined_[index(start)] = true;
    while (!open.empty()) {
      const Cell at = open.front();
      open.pop_front();
      for_neighbours(map_, at, [&](Cell next) {
        if (joined_[index(next)] || !fits(next, from_walls_)) return;
        joined_[index(next)] = true;
        open.push_back(next);
      });
    }
  }

  // A wavefront from `start` over cells that `may_pass`, nearest first, until `visit(cell, length)` says so.
  template <class MayPass, class Visit>
  void expand(Cell start, std::vector<double>& length, MayPass may_pass, Visit visit) const {
    using Open = std::pair<double, std::size_t>;
    std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
    length[index(start)] = 0.0;
    open.emplace(0.0, index(start));
    const auto width = static_cast<std::size_t>(map_.width);
    while (!open.empty()) {
      const auto [so_far, at] = open.top();
      open.pop();
      if (so_far > length[at]) continue;
      const Cell cell{static_cast<int>(at % width), static_cast<int>(at / width)};
      if (visit(cell, so_far)) return;
      for_neighbours(map_, cell, [&](Cell next) {
        if (!may_pass(next)) return;
        const bool is_diagonal = next.column != cell.column && next.row != cell.row;
        const double total = so_far + (is_diagonal ? std::sqrt(2.0) : 1.0) * map_.resolution;
        if (total >= length[index(next)]) return;
        length[index(next)] = total;
        open.emplace(total, index(next));
      });
    }
  }

  // Lengths of paths on which the robot touches nothing unknown.
  void measure_paths(Cell start) {
    path_.assign(map_.cells.size(), kNever);
    expand(
        start, path_, [&](Cell next) { return fits(next, from_unknown_); },
        [](Cell, double) { return false; });
  }

  bool is_frontier(Cell cell) const {
    if (!joined_[index(cell)]) return false;
    bool touches = false;
    for_neighbours(map_, cell, [&](Cell next) { touches |= map_.at(next.column, next.row) < 0; });
    return touches;
  }

  std::vector<Cell> cluster(Cell start, std::vector<bool>& taken) const {
    std::vector<Cell> cells{start};
    taken[index(start)] = true;
    for (std::size_t k = 0; k < cells.size(); ++k)
      for_neighbours(map_, cells[k], [&](Cell next) {
        if (taken[index(next)] || !is_frontier(next)) return;
        taken[index(next)] = true;
        cells.push_back(next);
      });
    return cells;
  }

  void add(const std::vector<Cell>& cells, FrontierSearch& result) {
    Frontier frontier;
    frontier.length = static_cast<double>(cells.size()) * map_.resolution;
    if (frontier.length < options_.least_length) return;
    Vector2 mean{0.0, 0.0};
    for (const Cell c : cells) mean += map_.center(c.column, c.row) / static_cast<double>(cells.size());
    const Cell centre = *std::ranges::min_element(
        cells, {}, [&](Cell c) { return (map_.center(c.column, c.row) - mean).squaredNorm(); });
    frontier.centre = map_.center(centre.column, centre.row);
    const std::optional<Cell> goal = goal_before(centre);
    if (!goal) {
      result.out_of_reach.push_back(frontier.centre);
      return;
    }
    const Vector2 at = map_.center(goal->column, goal->row);
    const Vector2 looks = frontier.centre - at;
    frontier.goal = {at.x(), at.y(), std::atan2(looks.y(), looks.x())};
    frontier.path_length = path_[index(*goal)];
    result.frontiers.push_back(frontier);
  }

  // The nearest cell, over those where the robot fits, that a path leads to.
  std::optional<Cell> goal_before(Cell frontier) {
    if (path_.empty()) return std::nullopt;
    std::optional<Cell> goal;
    std::vector<std::size_t> touched;
    expand(
        frontier, to_frontier_,
        [&](Cell next) {
          touched.push_back(index(next));
          return static_cast<bool>(joined_[index(next)]);
        },
        [&](Cell cell, double length) {
          if (path_[index(cell)] < kNever) goal = cell;
          return goal || length > kLooksIn;
        });
    to_frontier_[index(frontier)] = kNever;
    for (const std::size_t cell : touched) to_frontier_[cell] = kNever;
    return goal;
  }

  const OccupancyGrid& map_;
  FrontierOptions options_;
  std::vector<float> from_walls_;    // [m]
  std::vector<float> from_unknown_;  // of what is not known to be free [m]
  double clearance_ = 0.0;           // [m] between centres of cells
  std::vector<bool> joined_;
  std::vector<double> path_;         // [m]
  std::vector<double> to_frontier_;  // [m], kNever but in goal_before()
};

}  // namespace

FrontierSearch find_frontiers(const OccupancyGrid& map, const Vector2& robot,
                              const FrontierOptions& options) {
  if (map.cells.empty()) return {};
  return Search(map, options).run(robot);
}

}  // namespace bw::explore
