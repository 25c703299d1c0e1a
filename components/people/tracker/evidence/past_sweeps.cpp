#include "components/people/tracker/evidence/past_sweeps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bw::people {
namespace {

constexpr std::size_t kKept = 150;     // sweeps
constexpr double kEvery = 0.3;         // [s] between those that are kept, of each sensor
constexpr double kRadius = 0.08;       // [m] about a position that must be empty: a leg, and what S drifts
constexpr double kMargin = 0.05;       // [m] by which ranges err
constexpr double kNearestSeen = 0.3;   // [m] from the sensor
constexpr double kSpacing = 0.04;      // [m] between beams there, at most
constexpr int kEnough = 2;             // sweeps
constexpr double kAgo = 2.0;           // [s] since something stood there that is not what stands there now
constexpr double kAgeRounding = 1e-6;  // [s]
constexpr double kTwoPi = 2.0 * std::numbers::pi;

}  // namespace

void PastSweeps::reset() {
  for (Sweep& sweep : sweeps_) sweep.time = -1.0;
}

void PastSweeps::add(const DetectionSet& sweep, double now) {
  if (sweep.free_ranges.empty() || sweep.angle_increment == 0.0) return;
  const auto too_soon = [&](const Sweep& kept) {
    return kept.time >= 0.0 && kept.source == sweep.source && now - kept.time < kEvery - kAgeRounding;
  };
  if (std::ranges::any_of(sweeps_, too_soon)) return;
  if (sweeps_.size() < kKept) sweeps_.emplace_back();
  Sweep& kept = sweeps_[next_];
  next_ = (next_ + 1) % kKept;
  kept.source = sweep.source;
  kept.time = now;
  kept.sensor = sweep.sensor;
  kept.angle_min = sweep.angle_min;
  kept.angle_increment = sweep.angle_increment;
  kept.ranges.assign(sweep.free_ranges.begin(), sweep.free_ranges.end());
}

PastSweeps::Past PastSweeps::view_of(const Sweep& sweep, const Vector2& position) {
  const Vector2 offset = position - sweep.sensor;
  const double distance = offset.norm();
  const double step = std::abs(sweep.angle_increment);
  if (!(distance >= kNearestSeen && distance * step <= kSpacing)) return Past::unknown;
  double angle = std::atan2(offset.y(), offset.x()) - sweep.angle_min;
  if (sweep.angle_increment < 0.0) angle = -angle;
  angle -= kTwoPi * std::floor(angle / kTwoPi);
  const double half = std::asin(kRadius / distance);
  const double first = std::ceil((angle - half) / step);
  const double last = std::floor((angle + half) / step);
  if (!(first >= 0.0 && last < static_cast<double>(sweep.ranges.size()) && last > first))
    return Past::unknown;
  const auto before = static_cast<float>(distance - kRadius - kMargin);
  const auto behind = static_cast<float>(distance + kRadius + kMargin);
  bool hidden = false;
  for (auto i = static_cast<std::size_t>(first); i <= static_cast<std::size_t>(last); ++i) {
    const float range = sweep.ranges[i];
    if (range >= before && range <= behind) return Past::occupied;
    if (range < before) hidden = true;
  }
  return hidden ? Past::unknown : Past::empty;
}

PastSweeps::Past PastSweeps::at(const Vector2& position, double now) const {
  int empty = 0;
  int occupied = 0;
  int before = 0;
  bool was_empty = false;
  for (std::size_t k = 0; k < sweeps_.size(); ++k) {
    const Sweep& sweep = sweeps_[(next_ + k) % sweeps_.size()];
    if (sweep.time < 0.0) continue;
    const Past view = view_of(sweep, position);
    if (view == Past::empty && ++empty >= kEnough) {
      was_empty = true;
      before = occupied;
    }
    if (view != Past::occupied) continue;
    empty = 0;
    if (now - sweep.time > kAgo) ++occupied;
  }
  // Something stood there, was not seen for a while, and is seen again: as thin things are between the beams.
  if (was_empty) return before >= kEnough ? Past::unknown : Past::empty;
  return occupied >= kEnough ? Past::occupied : Past::unknown;
}

}  // namespace bw::people
