#include "components/explore/frontier_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "components/explore/beam_gaps.hpp"
#include "components/explore/wavefront.hpp"

namespace bw::explore {
namespace {

constexpr ObstacleRule kOccupied{.unknown_is_obstacle = false};
constexpr ObstacleRule kNotKnownFree{.unknown_is_obstacle = true};
constexpr double kBeside = 0.5;   // [m] from a robot that stands where it does not fit to where it does
constexpr double kRoom = 0.15;    // [m] that a goal has around the robot, where there is such a place
constexpr double kForRoom = 1.5;  // [m] from the frontier to such a place

/// Around a goal, beside what the robot takes up.
enum class Room { wanted, none };

class Search {
 public:
  Search(const OccupancyGrid& map, const FrontierOptions& options)
      : map_(map), closed_(without_beam_gaps(map, 2.0 * options.radius)), options_(options) {}

  FrontierSearch run(const Vector2& robot) {
    FrontierSearch result;
    const std::vector<bool> fits = cells_for_disc(closed_, options_.radius, kOccupied);
    const std::vector<Cell> start = cells_beside(map_, fits, robot, kBeside);
    if (start.empty()) return result;
    result.is_placed = true;
    joined_ = wavefront(map_, fits, start);
    seen_.assign(map_.cells.size(), 0);
    const std::vector<bool> is_safe = cells_for_disc(map_, options_.radius, kNotKnownFree);
    path_ = wavefront(map_, is_safe, cells_beside(map_, is_safe, robot, kBeside));
    is_roomy_ = cells_for_disc(map_, options_.radius + kRoom, kNotKnownFree);
    std::vector<bool> taken(map_.cells.size(), false);
    for (int row = 0; row < map_.height; ++row)
      for (int column = 0; column < map_.width; ++column)
        if (const Cell cell{column, row}; !taken[index(cell)] && is_frontier(cell))
          add(cluster(cell, taken), result);
    std::ranges::sort(result.frontiers, [](const Frontier& a, const Frontier& b) {
      if (a.path_length != b.path_length) return a.path_length < b.path_length;
      return std::pair(a.centre.x(), a.centre.y()) < std::pair(b.centre.x(), b.centre.y());
    });
    return result;
  }

 private:
  std::size_t index(Cell c) const { return map_.index(c.column, c.row); }

  bool is_frontier(Cell cell) const {
    if (joined_[index(cell)] == kUnreached) return false;
    bool touches = false;
    for_neighbours(map_, cell, [&](Cell next) { touches |= closed_.at(next.column, next.row) < 0; });
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
    std::optional<Cell> goal = goal_before(centre, Room::wanted);
    if (!goal) goal = goal_before(centre, Room::none);
    if (!goal) {
      result.out_of_reach.push_back(frontier.centre);
      return;
    }
    const Vector2 at = map_.center(goal->column, goal->row);
    const Vector2 looks = frontier.centre - at;
    frontier.goal = {at.x(), at.y(), std::atan2(looks.y(), looks.x())};
    frontier.path_length = joined_[index(centre)];
    result.frontiers.push_back(frontier);
  }

  // The cell that a path leads to and that is nearest to the frontier, by steps over cells where the robot fits; of
  // several the nearest as the crow flies. One with room is looked for about the frontier alone.
  std::optional<Cell> goal_before(Cell frontier, Room room) {
    ++search_;
    const int most = room == Room::wanted ? static_cast<int>(kForRoom / map_.resolution)
                                          : std::numeric_limits<int>::max() - 1;
    const Vector2 middle = map_.center(frontier.column, frontier.row);
    std::vector<Cell> ring{frontier};
    seen_[index(frontier)] = search_;
    for (int step = 0; step <= most && !ring.empty(); ++step) {
      std::optional<Cell> nearest;
      const auto away = [&](Cell c) { return (map_.center(c.column, c.row) - middle).squaredNorm(); };
      std::vector<Cell> next_ring;
      for (const Cell at : ring) {
        const bool is_goal = path_[index(at)] < kUnreached && (room == Room::none || is_roomy_[index(at)]);
        if (is_goal && (!nearest || away(at) < away(*nearest))) nearest = at;
        for_neighbours(map_, at, [&](Cell next) {
          if (seen_[index(next)] == search_ || joined_[index(next)] == kUnreached) return;
          seen_[index(next)] = search_;
          next_ring.push_back(next);
        });
      }
      if (nearest) return nearest;
      ring = std::move(next_ring);
    }
    return std::nullopt;
  }

  const OccupancyGrid& map_;
  OccupancyGrid closed_;  // with gaps between beams taken for free
  FrontierOptions options_;
  std::vector<double> joined_;  // where the robot fits if what is unknown is free; lengths of ways there [m]
  std::vector<double> path_;    // the same without touching what is unknown
  std::vector<bool> is_roomy_;
  std::vector<int> seen_;  // by which search for a goal
  int search_ = 0;
};

}  // namespace

FrontierSearch find_frontiers(const OccupancyGrid& map, const Vector2& robot,
                              const FrontierOptions& options) {
  if (map.cells.empty()) return {};
  return Search(map, options).run(robot);
}

}  // namespace bw::explore
