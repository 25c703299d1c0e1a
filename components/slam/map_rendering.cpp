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

std::int8_t MapRendering::value_of(const Counts& counts) {
  const int all = counts.hits + counts.passes;
  if (all < kLeastPasses) return OccupancyGrid::kUnknown;
  const bool occupied = counts.hits > 0 && counts.hits >= kOccupiedShare * all;
  return occupied ? OccupancyGrid::kOccupied : OccupancyGrid::kFree;
}

void MapRendering::mark(const TileIndex& tile) {
  last_ = tile;
  is_last_marked_ = true;
  std::uint8_t& is_changed = is_changed_.ref(tile.column, tile.row);
  if (is_changed != 0) return;
  is_changed = 1;
  changed_.push_back(tile);
}

void MapRendering::count(int i, int j, int hits, int passes) {
  const TileIndex tile{i >> TiledGrid<Counts>::kEdgeBits, j >> TiledGrid<Counts>::kEdgeBits};
  if (!is_last_marked_ || !(tile == last_)) mark(tile);
  Counts& counts = cells_.ref(i, j);
  counts.hits = static_cast<std::int16_t>(std::clamp(counts.hits + hits, 0, 30000));
  counts.passes = static_cast<std::int16_t>(std::clamp(counts.passes + passes, 0, 30000));
}

bool MapRendering::draw(const RangeImage& image, const Pose2& X_MB) {
  std::uint16_t longest = 0;
  for (const std::uint16_t mm : image.millimetres)
    if (mm != RangeImage::kNoReturn) longest = std::max(longest, mm);
  const Vector2 at = (X_MB * image.X_BL).position();
  const Vector2 reach = Vector2::Constant(0.001 * longest);
  Box box{(at - reach) / resolution_, (at + reach) / resolution_};
  if (!cells_.empty()) box = {drawn_.low.cwiseMin(box.low), drawn_.high.cwiseMax(box.high)};
  // [cells] that can be counted; of grid(), a tile on either side and one of rounding.
  constexpr double kFarthest = 1e9;
  constexpr double kMargin = 3 * MapTile::kEdge;
  const bool can_be = at.allFinite() && box.low.minCoeff() >= -kFarthest && box.high.maxCoeff() <= kFarthest;
  if (!can_be || ((box.high - box.low).array() + kMargin).prod() > kMostCells) return false;
  drawn_ = box;
  add(image, X_MB, 1);
  return true;
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
    grid.cells[grid.index(i - first_i, j - first_j)] = value_of(counts);
  });
  return grid;
}

void MapRendering::gather(std::size_t most, std::vector<MapTile>& tiles) {
  static_assert(MapTile::kEdge == TiledGrid<Counts>::kEdge);
  is_last_marked_ = false;
  for (; most > 0 && !changed_.empty(); --most) {
    const TileIndex index = changed_.front();
    changed_.pop_front();
    is_changed_.ref(index.column, index.row) = 0;
    MapTile& tile = tiles.emplace_back();
    tile.column = index.column;
    tile.row = index.row;
    const Counts* counts = cells_.tile_of(index.column * MapTile::kEdge, index.row * MapTile::kEdge);
    std::transform(counts, counts + tile.cells.size(), tile.cells.begin(), value_of);
  }
}

OccupancyGrid render(std::span<const PlacedScan> scans, double resolution) {
  MapRendering map(resolution);
  for (const PlacedScan& scan : scans) map.draw(*scan.ranges, scan.X_MB);
  return map.grid();
}

}  // namespace bw::slam
