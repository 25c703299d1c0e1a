#include "components/safety/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace bw::safety {
namespace {

constexpr double kTurn = 2.0 * std::numbers::pi;

SweepFault fault_of(const Sweep& sweep, const SweepOptions& options) {
  const bool finite = std::isfinite(sweep.angle_min) && std::isfinite(sweep.angle_max) &&
                      std::isfinite(sweep.angle_increment) && std::isfinite(sweep.range_min) &&
                      std::isfinite(sweep.range_max);
  const double step = std::abs(sweep.angle_increment);
  if (!finite || !(step > 1e-7) || sweep.range_min < 0.0 || sweep.range_max <= sweep.range_min ||
      std::abs(sweep.angle_min) > 2.0 * kTurn) {
    return SweepFault::bad_geometry;
  }
  const std::size_t count = sweep.ranges.size();
  if (count < 2 || count > static_cast<std::size_t>(options.max_beams)) return SweepFault::wrong_length;
  const double steps = static_cast<double>(count - 1);
  if (steps * step > kTurn + 2.0 * step) return SweepFault::wrong_length;
  // Some drivers name the angle after the last beam.
  const double last = sweep.angle_min + steps * sweep.angle_increment;
  return std::abs(last - sweep.angle_max) > 1.6 * step ? SweepFault::wrong_length : SweepFault::none;
}

Beam judge(float range, const Sweep& sweep) {
  if (std::isinf(range) && range > 0.0F) return Beam::clear;
  return range > 0.0F && range >= sweep.range_min && range <= sweep.range_max ? Beam::hit : Beam::unknown;
}

/// Hits with at least min_points - 1 of the two beams on either side at nearly the same range.
std::vector<bool> confirmed(const Sweep& sweep, const std::vector<Beam>& beams, const SweepOptions& options) {
  std::vector<bool> result(beams.size(), false);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (beams[i] != Beam::hit) continue;
    const std::size_t last = std::min(i + 2, beams.size() - 1);
    int agree = 0;
    for (std::size_t j = i < 2 ? 0 : i - 2; j <= last; ++j) {
      const bool near = std::abs(sweep.ranges[j] - sweep.ranges[i]) <= options.point_spacing;
      if (beams[j] == Beam::hit && near) ++agree;
    }
    result[i] = agree >= options.min_points;
  }
  return result;
}

/// Marks things no wider than narrow_width with free sight past at least one edge.
class NarrowThings {
 public:
  NarrowThings(const SweepOptions& options, CheckedSweep& out) : options_(options), out_(out) {}

  /// Confirmed hits in the order of the beams; `range` [m].
  void add(const Vector2& position, double range) {
    if (open_ && (position - last_).norm() > jump(range)) close(range > range_);
    if (!open_) {
      open_ = true;
      first_ = out_.points.size();
      begin_ = position;
      free_before_ = gap_ || range < range_;
    }
    out_.points.push_back({position, false});
    last_ = position;
    range_ = range;
    gap_ = false;
  }
  /// A beam that sees past everything near.
  void clear() {
    close(true);
    gap_ = true;
  }
  /// The end of the sweep; what the laser cannot see past may go on there.
  void finish() { close(false); }

 private:
  /// Two points farther apart are of two things.
  double jump(double range) const {
    return std::max(options_.point_spacing, 4.0 * range * std::abs(out_.angle_increment));
  }
  void close(bool free_after) {
    if (!open_) return;
    open_ = false;
    if (!(free_before_ || free_after) || (last_ - begin_).norm() > options_.narrow_width) return;
    for (std::size_t i = first_; i < out_.points.size(); ++i) out_.points[i].is_narrow = true;
  }

  const SweepOptions& options_;
  CheckedSweep& out_;
  bool open_ = false;
  bool gap_ = false;
  bool free_before_ = false;
  std::size_t first_ = 0;
  Vector2 begin_{0.0, 0.0};
  Vector2 last_{0.0, 0.0};
  double range_ = 0.0;
};

}  // namespace

std::string_view describe(SweepFault fault) {
  switch (fault) {
    case SweepFault::none:
      return "the sweep is sound";
    case SweepFault::bad_geometry:
      return "angles or range limits of the sweep make no sense";
    case SweepFault::wrong_length:
      return "the number of ranges does not fit the angles of the sweep";
    case SweepFault::no_returns:
      return "the sweep hits nothing";
    case SweepFault::mostly_unknown:
      return "most beams of the sweep are unusable";
  }
  return "unknown";
}

CheckedSweep check_sweep(const Sweep& sweep, const Pose2& X_BS, const SweepOptions& options) {
  CheckedSweep out;
  out.fault = fault_of(sweep, options);
  if (out.fault != SweepFault::none) return out;
  out.angle_min = X_BS.theta + sweep.angle_min;
  out.angle_increment = sweep.angle_increment;
  out.beams.reserve(sweep.ranges.size());
  for (const float range : sweep.ranges) out.beams.push_back(judge(range, sweep));
  const auto count = [&](Beam beam) { return std::count(out.beams.begin(), out.beams.end(), beam); };
  if (static_cast<double>(count(Beam::unknown)) >
      options.max_unknown * static_cast<double>(out.beams.size())) {
    out.fault = SweepFault::mostly_unknown;
  } else if (count(Beam::hit) < options.min_returns) {
    out.fault = SweepFault::no_returns;
  }
  if (out.fault != SweepFault::none) {
    out.beams.clear();
    return out;
  }
  const std::vector<bool> keep = confirmed(sweep, out.beams, options);
  NarrowThings things(options, out);
  for (std::size_t i = 0; i < out.beams.size(); ++i) {
    const double range = sweep.ranges[i];
    if (out.beams[i] == Beam::clear) things.clear();
    if (keep[i]) {
      const double angle = sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
      things.add(X_BS * Vector2(range * direction(angle)), range);
    }
  }
  things.finish();
  return out;
}

Sight sight_of(const CheckedSweep& sweep, double bearing, double half_angle) {
  Sight sight;
  const double step = std::abs(sweep.angle_increment);
  int looking = 0;
  int unknown = 0;
  double run = 0.0;
  for (std::size_t i = 0; i < sweep.beams.size(); ++i) {
    const double angle = sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
    if (std::abs(wrap_angle(angle - bearing)) > half_angle) {
      run = 0.0;
      continue;
    }
    ++looking;
    const bool is_unknown = sweep.beams[i] == Beam::unknown;
    unknown += is_unknown ? 1 : 0;
    run = is_unknown ? run + step : 0.0;
    sight.widest_gap = std::max(sight.widest_gap, run);
  }
  if (looking == 0) return sight;
  sight.covered = std::min(1.0, looking * step / (2.0 * half_angle));
  sight.unknown = static_cast<double>(unknown) / looking;
  return sight;
}

}  // namespace bw::safety
