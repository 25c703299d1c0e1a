// map_walls MAP.yaml WITHIN X1,Y1,X2,Y2...: how many cells of a saved map are occupied, and which share of them
// has its centre within so many metres of a wall. Printed as "CELLS SHARE", the share in per cent.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "components/files/map_file.hpp"
#include "components/model/obstacles.hpp"

namespace {

double distance(const bw::Segment& wall, const bw::Vector2& p) {
  const bw::Vector2 along = wall.b - wall.a;
  const double s = std::clamp((p - wall.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (p - wall.a - s * along).norm();
}

}  // namespace

int main(int count, char** arguments) try {
  if (count < 4) return 2;
  const bw::OccupancyGrid map = bw::load_map(arguments[1]);
  const double within = std::atof(arguments[2]);
  std::vector<bw::Segment> walls;
  for (int i = 3; i < count; ++i) {
    bw::Segment wall;
    if (std::sscanf(arguments[i], "%lf,%lf,%lf,%lf", &wall.a.x(), &wall.a.y(), &wall.b.x(), &wall.b.y()) != 4)
      return 2;
    walls.push_back(wall);
  }
  int cells = 0;
  int near = 0;
  for (int row = 0; row < map.height; ++row) {
    for (int column = 0; column < map.width; ++column) {
      if (map.at(column, row) != bw::OccupancyGrid::kOccupied) continue;
      ++cells;
      const bw::Vector2 p = map.center(column, row);
      near += std::any_of(walls.begin(), walls.end(),
                          [&](const bw::Segment& w) { return distance(w, p) <= within; });
    }
  }
  std::printf("%d %.1f\n", cells, cells == 0 ? 0.0 : 100.0 * near / cells);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
