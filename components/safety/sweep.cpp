#include "components/safety/sweep.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "components/model/transform2.hpp"

namespace bw::safety {
namespace {

/// Hits with at least min_points - 1 of the two beams on either side at nearly the same range.
std::vector<bool> confirmed(const LaserSweep& sweep, const std::vector<BeamKind>& beams,
                            const SweepOptions& options) {
  std::vector<bool> result(beams.size(), false);
  for (std::size_t i = 0; i < beams.size(); ++i) {
    if (beams[i] != BeamKind::hit) continue;
    const std::size_t last = std::min(i + 2, beams.size() - 1);
    int agree = 0;
    for (std::size_t j = i < 2 ? 0 : i - 2; j <= last; ++j) {
      const bool near = std::abs(sweep.ranges[j] - sweep.ranges[i]) <= options.kPointSpacing;
      if (beams[j] == BeamKind::hit && near) ++agree;
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
    return std::max(options_.kPointSpacing, 4.0 * range * std::abs(out_.angle_increment));
  }
  void close(bool free_after) {
    if (!open_) return;
    open_ = false;
    if (!(free_before_ || free_after) || (last_ - begin_).norm() > options_.kNarrowWidth) return;
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

bool says_something(const CheckedSweep& sweep, std::size_t beam) {
  return sweep.beams[beam] != BeamKind::unknown && (sweep.dark.empty() || !sweep.dark[beam]);
}

}  // namespace

CheckedSweep check_sweep(const LaserSweep& sweep, const SweepOptions& options) {
  CheckedSweep out;
  out.fault = fault_of(sweep);
  if (out.fault != SweepFault::none) return out;
  out.angle_min = sweep.X_FL.theta + sweep.angle_min;
  out.angle_increment = sweep.angle_increment;
  out.laser = sweep.X_FL.position();
  out.beams.reserve(sweep.ranges.size());
  for (const float range : sweep.ranges) out.beams.push_back(kind_of(range, sweep));
  const auto count = [&](BeamKind beam) { return std::count(out.beams.begin(), out.beams.end(), beam); };
  if (static_cast<double>(count(BeamKind::unknown)) >
      options.kMaxUnknown * static_cast<double>(out.beams.size())) {
    out.fault = SweepFault::mostly_unknown;
    out.beams.clear();
    return out;
  }
  const std::vector<bool> keep = confirmed(sweep, out.beams, options);
  NarrowThings things(options, out);
  const Transform2 X_FL(sweep.X_FL);
  for (std::size_t i = 0; i < out.beams.size(); ++i) {
    const double range = sweep.ranges[i];
    if (out.beams[i] == BeamKind::free) things.clear();
    if (keep[i]) {
      const double angle = sweep.angle_min + static_cast<double>(i) * sweep.angle_increment;
      const Vector2 p_L = range * direction(angle);
      things.add(sweep.beam_poses.empty() ? X_FL * p_L : sweep.beam_poses[i] * p_L, range);
    }
  }
  things.finish();
  return out;
}

Sight sight_of(const CheckedSweep& sweep, double bearing, double half_angle) {
  Sight sight;
  const double step = std::abs(sweep.angle_increment);
  const std::size_t n = sweep.beams.size();
  const auto looks = [&](double angle) { return std::abs(wrap_angle(angle - bearing)) <= half_angle; };
  const auto angle_of = [&](double beam) { return sweep.angle_min + beam * sweep.angle_increment; };
  // Nobody looks from the last beam on to the first: little or nothing of a revolution, much of a narrower
  // field.
  const double missing = std::max(0.0, 2.0 * std::numbers::pi - static_cast<double>(n) * step);
  const bool is_missing =
      looks(angle_of(static_cast<double>(n) - 0.5) + 0.5 * std::copysign(missing, sweep.angle_increment));
  std::size_t looking = 0;
  std::size_t unknown = 0;
  std::size_t dark = 0;
  double run = 0.0;
  // Twice round: a gap may go on where the sweep ends and begins.
  for (std::size_t i = 0; i < 2 * n; ++i) {
    if (i == n) run = is_missing || missing < step ? run + missing : 0.0;
    const std::size_t beam = i % n;
    const bool counts = looks(angle_of(static_cast<double>(beam)));
    const bool is_unknown = counts && !says_something(sweep, beam);
    run = is_unknown ? run + step : 0.0;
    sight.widest_gap = std::max(sight.widest_gap, std::min(run, 2.0 * half_angle));
    if (i >= n) continue;
    looking += counts ? 1 : 0;
    unknown += is_unknown ? 1 : 0;
    dark += counts && !sweep.dark.empty() && sweep.dark[beam] ? 1 : 0;
  }
  if (looking == 0) return sight;
  sight.covered = std::min(1.0, static_cast<double>(looking) * step / (2.0 * half_angle));
  sight.unknown = static_cast<double>(unknown) / static_cast<double>(looking);
  sight.dark = static_cast<double>(dark) / static_cast<double>(looking);
  return sight;
}

bool sees(const CheckedSweep& sweep, const Vector2& position) {
  const Vector2 offset = position - sweep.laser;
  const double revolution = 2.0 * std::numbers::pi;
  double off = std::fmod((std::atan2(offset.y(), offset.x()) - sweep.angle_min) / sweep.angle_increment,
                         revolution / std::abs(sweep.angle_increment));
  if (off < 0.0) off += revolution / std::abs(sweep.angle_increment);
  const auto nearest = static_cast<std::ptrdiff_t>(std::lround(off));
  for (std::ptrdiff_t beam = nearest - 1; beam <= nearest + 1; ++beam) {
    if (beam >= 0 && beam < std::ssize(sweep.beams) && says_something(sweep, static_cast<std::size_t>(beam)))
      return true;
  }
  return false;
}

}  // namespace bw::safety
