#include "components/lab/bench/explore/coverage.hpp"

#include <cstddef>
#include <stdexcept>

#include "components/lab/bench/buildings/known_map.hpp"
#include "components/lab/bench/explore/growing_map.hpp"

namespace bw {
namespace {

constexpr double kBeside = 0.5;  // [m] from the start to where the robot fits
constexpr double kSeen = 0.995;

using explore::Cell;

class Tour {
 public:
  Tour(const Explorable& place, double range) : place_(place), seen_(place, range), at_(place.start) {}

  double length() {
    seen_.look(at_);
    while (seen_.share() < kSeen) go_to(explore::wavefront(place_.truth, place_.cells, {at_}));
    return length_;
  }

 private:
  const OccupancyGrid& map() const { return place_.truth; }
  std::size_t index(Cell c) const { return map().index(c.column, c.row); }

  // Along the shortest path to the nearest cell that was not seen, until it is.
  void go_to(const std::vector<double>& length) {
    std::size_t target = 0;
    double nearest = explore::kUnreached;
    for (std::size_t i = 0; i < length.size(); ++i) {
      if (seen_.is_known(i) || length[i] >= nearest) continue;
      nearest = length[i];
      target = i;
    }
    if (nearest == explore::kUnreached) throw std::logic_error("a cell to see that no path leads to");
    const auto width = static_cast<std::size_t>(map().width);
    std::vector<Cell> path{{static_cast<int>(target % width), static_cast<int>(target / width)}};
    while (length[index(path.back())] > 0.0) {
      Cell next = path.back();
      explore::for_neighbours(map(), path.back(), [&](Cell cell) {
        if (length[index(cell)] < length[index(next)]) next = cell;
      });
      path.push_back(next);
    }
    const double whole = length_;
    for (std::size_t k = path.size() - 1; k-- > 0 && !seen_.is_known(target);) {
      at_ = path[k];
      length_ = whole + length[index(at_)];
      seen_.look(at_);
    }
  }

  const Explorable& place_;
  GrowingMap seen_;
  Cell at_;
  double length_ = 0.0;
};

}  // namespace

Explorable explorable(const buildings::Building& building, double radius, double resolution) {
  Explorable place;
  place.truth = buildings::known_map(building, resolution);
  const std::vector<bool> fits = explore::cells_for_disc(place.truth, radius, {.unknown_is_obstacle = true});
  const auto start = explore::cells_beside(place.truth, fits, building.route.front(), kBeside);
  if (start.empty()) throw std::runtime_error(building.name + ": the robot does not fit where it starts");
  place.start = start.front();
  const std::vector<double> length = explore::wavefront(place.truth, fits, {place.start});
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
