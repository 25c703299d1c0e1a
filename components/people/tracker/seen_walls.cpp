#include "components/people/tracker/seen_walls.hpp"

#include <algorithm>

namespace bw::people {
namespace {

constexpr float kPause = 0.5F;   // [s] within which the next beam must end there
constexpr double kPerson = 0.5;  // [m] about people nothing is a wall
constexpr double kGap = 0.3;     // [m] between points of neighbouring beams, nobody fits through

}  // namespace

SeenWalls::SeenWalls() : cells_(static_cast<std::size_t>(kSide) * kSide) {}

void SeenWalls::add(const DetectionSet& sweep, double now, std::span<const Vector2> people) {
  now_ = static_cast<float>(now);
  if (sweep.free_ranges.empty()) return;
  const float nothing = *std::ranges::max_element(sweep.free_ranges);  // hit by no beam this long
  const Vector2* before = nullptr;
  Vector2 points[2];
  for (std::size_t i = 0; i < sweep.free_ranges.size(); ++i) {
    const float range = sweep.free_ranges[i];
    Vector2& point = points[i % 2];
    point = sweep.sensor + static_cast<double>(range) *
                               direction(sweep.angle_min + static_cast<double>(i) * sweep.angle_increment);
    const auto near = [&](const Vector2& person) {
      return (person - point).squaredNorm() < kPerson * kPerson;
    };
    if (!(range > 0.0F && range < nothing) || !is_near(point) || std::ranges::any_of(people, near)) {
      before = nullptr;
      continue;
    }
    mark(point);
    if (before != nullptr && (*before - point).norm() < kGap) mark((*before + point) / 2.0);
    before = &point;
  }
}

void SeenWalls::mark(const Vector2& p_S) {
  const std::int32_t column = to_cell(p_S.x());
  const std::int32_t row = to_cell(p_S.y());
  Cell& cell = cells_[slot_of(column, row)];
  const bool same = cell.column == column && cell.row == row && now_ - cell.last <= kRemembered;
  const bool stood = same && cell.last - cell.since >= kWallAge;
  if (!same || (!stood && now_ - cell.last > kPause)) cell = {column, row, now_, now_};
  cell.last = now_;
}

void SeenWalls::reset() { std::ranges::fill(cells_, Cell{}); }

}  // namespace bw::people
