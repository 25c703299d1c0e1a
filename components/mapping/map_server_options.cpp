#include "components/mapping/map_server_options.hpp"

#include <cmath>

#include "components/mapping/rasterize.hpp"

namespace bw {
namespace {

constexpr double kMaxCells = 64.0 * 1024 * 1024;

// A length that is a whole number of cells but for rounding gets no cell more.
double cells_along(double length, double resolution) { return std::ceil(length / resolution - 1e-6); }

}  // namespace

std::optional<std::string> MapServerOptions::violated_rule() const {
  if (!map.empty()) return std::nullopt;
  if (area.length <= 0.0 || area.width <= 0.0)
    return "either map or an area of some length and width must be given";
  if (cells_along(area.length, area.resolution) * cells_along(area.width, area.resolution) > kMaxCells) {
    return "the area must have at most 67108864 cells: raise its resolution";
  }
  return std::nullopt;
}

OccupancyGrid area_grid(const AreaOptions& area) {
  OccupancyGrid grid{.resolution = area.resolution,
                     .origin = {area.x, area.y},
                     .width = static_cast<int>(cells_along(area.length, area.resolution)),
                     .height = static_cast<int>(cells_along(area.width, area.resolution))};
  grid.cells.assign(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height),
                    OccupancyGrid::kFree);
  return grid;
}

void draw_shapes(OccupancyGrid& grid, const std::vector<WallOptions>& walls,
                 const std::vector<BoxOptions>& boxes) {
  for (const WallOptions& wall : walls) draw_segment(grid, {{wall.x1, wall.y1}, {wall.x2, wall.y2}});
  for (const BoxOptions& box : boxes) {
    const std::array<Vector2, 4> corners = box.corners();
    draw_convex(grid, {corners.begin(), corners.end()});
  }
}

}  // namespace bw
