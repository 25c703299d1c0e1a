#include "components/slam/map_rendering.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace bw::slam {
namespace {

constexpr double kOccupiedShare = 0.25;  // of the beams that came to a cell
constexpr int kLeastPasses = 1;          // from which on a cell is known to be free

}  // namespace

void MapRendering::count(int i, int j, int hits, int passes) {
  Counts& counts = cells_.ref(i, j);
  counts.hits = static_cast<std::int16_t>(std::clamp(counts.hits + hits, 0, 30000));
  counts.passes = static_cast<std::int16_t>(std::clamp(counts.passes + passes, 0, 30000));
}

void MapRendering::add(const RangeImage& image, const Pose2& X_MB, int sign) {
  const Pose2 X_ML = X_MB * image.X_BL;
  const double per_metre = 1.0 / resolution_;
  const double x0 = X_ML.x * per_metre;
  const double y0 = X_ML.y * per_metre;
  for (std::size_t beam = 0; beam < image.millimetres.size(); ++beam) {
    const std::uint16_t mm = image.millimetres[beam];
    // What a beam without return went through is not sure: glass and dark walls give none either.
    if (mm == RangeImage::kUnknown || mm == RangeImage::kNoReturn) continue;
    const double angle = X_ML.theta + image.angle_min + static_cast<double>(beam) * image.angle_increment;
    const double length = 0.001 * mm * per_metre;
    const double x1 = x0 + length * std::cos(angle);
    const double y1 = y0 + length * std::sin(angle);
    int i = static_cast<int>(std::floor(x0));
    int j = static_cast<int>(std::floor(y0));
    const int last_i = static_cast<int>(std::floor(x1));
    const int last_j = static_cast<int>(std::floor(y1));
    // Cells in the order in which the beam crosses their edges (Amanatides and Woo 1987).
    const double dx = x1 - x0;
    const double dy = y1 - y0;
    const int step_i = dx > 0.0 ? 1 : -1;
    const int step_j = dy > 0.0 ? 1 : -1;
    constexpr double kNever = std::numeric_limits<double>::infinity();
    const double by_i = dx == 0.0 ? kNever : std::abs(1.0 / dx);
    const double by_j = dy == 0.0 ? kNever : std::abs(1.0 / dy);
    double at_i = dx == 0.0 ? kNever : (dx > 0.0 ? i + 1 - x0 : x0 - i) * by_i;
    double at_j = dy == 0.0 ? kNever : (dy > 0.0 ? j + 1 - y0 : y0 - j) * by_j;
    for (int left = std::abs(last_i - i) + std::abs(last_j - j); left > 0; --left) {
      count(i, j, 0, sign);
      if (at_i < at_j) {
        i += step_i;
        at_i += by_i;
      } else {
        j += step_j;
        at_j += by_j;
      }
    }
    count(last_i, last_j, sign, 0);
  }
}

OccupancyGrid MapRendering::grid() const {
  OccupancyGrid grid;
  grid.resolution = resolution_;
  if (cells_.empty()) return grid;
  constexpr int kLargest = std::numeric_limits<int>::max();
  int left = kLargest;
  int low = kLargest;
  int right = -kLargest;
  int high = -kLargest;
  cells_.for_each([&](int i, int j, const Counts& counts) {
    if (counts.hits == 0 && counts.passes == 0) return;
    left = std::min(left, i);
    right = std::max(right, i);
    low = std::min(low, j);
    high = std::max(high, j);
  });
  if (left > right) return grid;
  // In steps of a tile, so that the origin stays where it was while the map grows a little.
  constexpr int kTile = TiledGrid<Counts>::kEdge;
  const auto down = [](int v) { return (v >= 0 ? v / kTile : -((-v + kTile - 1) / kTile)) * kTile; };
  const int first_i = down(left) - kTile;
  const int first_j = down(low) - kTile;
  grid.width = down(right) + 2 * kTile - first_i;
  grid.height = down(high) + 2 * kTile - first_j;
  grid.origin = {first_i * resolution_, first_j * resolution_};
  grid.cells.assign(static_cast<std::size_t>(grid.width) * static_cast<std::size_t>(grid.height),
                    OccupancyGrid::kUnknown);
  cells_.for_each([&](int i, int j, const Counts& counts) {
    const int all = counts.hits + counts.passes;
    if (all < kLeastPasses) return;
    const bool occupied = counts.hits > 0 && counts.hits >= kOccupiedShare * all;
    grid.cells[grid.index(i - first_i, j - first_j)] =
        occupied ? OccupancyGrid::kOccupied : OccupancyGrid::kFree;
  });
  return grid;
}

}  // namespace bw::slam
