#include "components/people/detector/local_background.hpp"

#include <algorithm>
#include <cmath>

namespace bw::people {
namespace {

constexpr float kLongestSilence = 0.5F;  // a longer silence is no proof that something stood meanwhile [s]
constexpr double kRemembered = 2.0;      // a cell holds at most so many times `stood`
constexpr double kFarthest = 1e8;        // cells are numbered by int

}  // namespace

LocalBackground::LocalBackground(const BackgroundOptions& options)
    : options_(options), cells_(static_cast<std::size_t>(kSide) * kSide) {}

void LocalBackground::reset() {
  std::fill(cells_.begin(), cells_.end(), Cell{});
  active_.clear();
  sweep_ = 0;
}

int LocalBackground::to_cell(double coordinate) const {
  return static_cast<int>(std::floor(std::clamp(coordinate / options_.kCell, -kFarthest, kFarthest)));
}

std::size_t LocalBackground::slot_of(int column, int row) {
  const auto wrap = [](int i) { return static_cast<std::size_t>(i & (kSide - 1)); };
  return wrap(row) * kSide + wrap(column);
}

bool LocalBackground::stood_long(int column, int row) const {
  const Cell& cell = slot(column, row);
  return cell.column == column && cell.row == row && cell.stood >= static_cast<float>(options_.kStood);
}

bool LocalBackground::contains(const Vector2& p_O) const {
  const int column = to_cell(p_O.x());
  const int row = to_cell(p_O.y());
  for (int dr = -1; dr <= 1; ++dr) {
    for (int dc = -1; dc <= 1; ++dc) {
      if (stood_long(column + dc, row + dr)) return true;
    }
  }
  return false;
}

void LocalBackground::learn(const Beams& beams, Time time, std::span<const Vector2> people) {
  const Duration since = time - last_;
  const bool first = sweep_ == 0;
  if (!first && since.nanoseconds <= 0) return;
  const float elapsed = first ? 0.0F : std::min(static_cast<float>(since.to_seconds()), kLongestSilence);
  last_ = time;
  ++sweep_;
  mark(beams, elapsed, people);
  clear(beams, elapsed);
}

void LocalBackground::mark(const Beams& beams, float elapsed, std::span<const Vector2> people) {
  const float most = static_cast<float>(kRemembered * options_.kStood);
  const double reach = (0.5 * kSide - 2.0) * options_.kCell;
  const double keep_out_squared = options_.kKeepOut * options_.kKeepOut;
  for (int i = 0; i < beams.size(); ++i) {
    const auto beam = static_cast<std::size_t>(i);
    if (beams.kinds[beam] != BeamKind::hit || beams.ranges[beam] > reach) continue;
    const Vector2& p = beams.points[beam];
    const int column = to_cell(p.x());
    const int row = to_cell(p.y());
    const std::size_t index = slot_of(column, row);
    Cell& cell = cells_[index];
    if (cell.column != column || cell.row != row) {
      const bool listed = cell.listed;
      cell = {column, row, 0.0F, 0, listed};
    }
    if (cell.sweep == sweep_) continue;
    cell.sweep = sweep_;
    const bool human = std::any_of(people.begin(), people.end(), [&](const Vector2& person) {
      return (person - p).squaredNorm() < keep_out_squared;
    });
    if (human) continue;
    cell.stood = std::min(cell.stood + elapsed, most);
    if (!cell.listed) {
      cell.listed = true;
      active_.push_back(index);
    }
  }
}

void LocalBackground::clear(const Beams& beams, float elapsed) {
  const int column = to_cell(beams.sensor.x());
  const int row = to_cell(beams.sensor.y());
  const float loss = static_cast<float>(options_.kForget) * elapsed;
  std::size_t kept = 0;
  for (const std::size_t index : active_) {
    Cell& cell = cells_[index];
    const bool left_behind =
        std::abs(cell.column - column) >= kSide / 2 || std::abs(cell.row - row) >= kSide / 2;
    if (!left_behind && cell.sweep != sweep_) {
      const Vector2 center((cell.column + 0.5) * options_.kCell, (cell.row + 0.5) * options_.kCell);
      const Vector2 offset = center - beams.sensor;
      const double bearing = wrap_angle(std::atan2(offset.y(), offset.x()) - beams.angle_min);
      const double from_first = bearing < 0.0 ? bearing + 2.0 * std::numbers::pi : bearing;
      const auto beam = static_cast<std::size_t>(std::lround(from_first / beams.angle_increment));
      // A beam that ends just behind the cell's middle may have touched the thing in it.
      const bool seen_through =
          beam < beams.ranges.size() && beams.ranges[beam] > offset.norm() + options_.kCell;
      if (seen_through) cell.stood -= loss;
    }
    if (left_behind || cell.stood < 0.0F) {
      cell.stood = 0.0F;
      cell.listed = false;
    } else {
      active_[kept++] = index;
    }
  }
  active_.resize(kept);
}

}  // namespace bw::people
