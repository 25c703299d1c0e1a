#include "components/lab/bench/explore/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>

#include "components/lab/bench/buildings/known_map.hpp"

namespace bw {
namespace {

constexpr double kBeside = 0.5;  // [m] from the start to where the robot fits
constexpr double kSeen = 0.995;
constexpr int kRays = 1440;

using explore::Cell;

class Tour {
 public:
  Tour(const Explorable& place, double range)
      : place_(place), reach_(range / place.truth.resolution), is_seen_(place.cells.size(), false) {
    to_see_ = static_cast<std::size_t>(std::ranges::count(place.cells, true));
    at_ = place.start;
  }

  double length() {
    look();
    const auto enough = static_cast<std::size_t>(kSeen * static_cast<double>(to_see_));
    while (seen_ < enough) go_to(explore::wavefront(place_.truth, place_.cells, at_));
    return length_;
  }

 private:
  const OccupancyGrid& map() const { return place_.truth; }
  std::size_t index(Cell c) const { return map().index(c.column, c.row); }

  void look() {
    for (int k = 0; k < kRays; ++k) {
      const double angle = 2.0 * std::numbers::pi * k / kRays;
      const double dx = 0.5 * std::cos(angle);
      const double dy = 0.5 * std::sin(angle);
      double x = at_.column + 0.5;
      double y = at_.row + 0.5;
      for (double along = 0.0; along <= reach_; along += 0.5, x += dx, y += dy) {
        const Cell cell{static_cast<int>(x), static_cast<int>(y)};
        if (!map().contains(cell.column, cell.row)) break;
        const std::size_t i = index(cell);
        if (map().cells[i] != OccupancyGrid::kFree) break;
        if (is_seen_[i]) continue;
        is_seen_[i] = true;
        if (place_.cells[i]) ++seen_;
      }
    }
  }

  // Along the shortest way to the nearest cell that was not seen, until it is.
  void go_to(const std::vector<double>& length) {
    std::size_t target = 0;
    double nearest = explore::kUnreached;
    for (std::size_t i = 0; i < length.size(); ++i) {
      if (is_seen_[i] || length[i] >= nearest) continue;
      nearest = length[i];
      target = i;
    }
    if (nearest == explore::kUnreached) throw std::logic_error("a cell to see that no way leads to");
    const auto width = static_cast<std::size_t>(map().width);
    std::vector<Cell> way{{static_cast<int>(target % width), static_cast<int>(target / width)}};
    while (length[index(way.back())] > 0.0) {
      Cell next = way.back();
      explore::for_neighbours(map(), way.back(), [&](Cell cell) {
        if (length[index(cell)] < length[index(next)]) next = cell;
      });
      way.push_back(next);
    }
    const double whole = length_;
    for (std::size_t k = way.size() - 1; k-- > 0 && !is_seen_[target];) {
      at_ = way[k];
      length_ = whole + length[index(at_)];
      look();
    }
  }

  const Explorable& place_;
  double reach_;  // [cells]
  std::vector<bool> is_seen_;
  std::size_t to_see_ = 0;
  std::size_t seen_ = 0;  // of them
  Cell at_;
  double length_ = 0.0;
};

}  // namespace

Explorable explorable(const buildings::Building& building, double radius, double resolution) {
  Explorable place;
  place.truth = buildings::known_map(building, resolution);
  const std::vector<bool> fits = explore::cells_for_disc(place.truth, radius, {.unknown_is_obstacle = true});
  const auto start = explore::nearest_cell(place.truth, fits, building.route.front(), kBeside);
  if (!start) throw std::runtime_error(building.name + ": the robot does not fit where it starts");
  place.start = *start;
  const std::vector<double> length = explore::wavefront(place.truth, fits, *start);
  place.cells.assign(length.size(), false);
  for (std::size_t i = 0; i < length.size(); ++i) place.cells[i] = length[i] < explore::kUnreached;
  return place;
}

double coverage(const Explorable& place, const OccupancyGrid& map) {
  constexpr ObstacleRule kOccupied{};
  std::size_t all = 0;
  std::size_t known = 0;
  for (int row = 0; row < place.truth.height; ++row) {
    for (int column = 0; column < place.truth.width; ++column) {
      if (!place.cells[place.truth.index(column, row)]) continue;
      ++all;
      const Vector2 centre = place.truth.center(column, row);
      const int c = map.column_of(centre.x());
      const int r = map.row_of(centre.y());
      if (map.contains(c, r) && map.at(c, r) >= 0 && !kOccupied.blocks(map.at(c, r))) ++known;
    }
  }
  return all == 0 ? 0.0 : static_cast<double>(known) / static_cast<double>(all);
}

double greedy_tour(const Explorable& place, double range) { return Tour(place, range).length(); }

}  // namespace bw
