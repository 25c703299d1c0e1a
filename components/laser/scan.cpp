#include "components/laser/scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bw::laser {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kSlant = 3.0;  // tangent of 72 degrees: the steepest view of what still is one surface
constexpr double kMaxApart =
    3.0;  // beams further from the next sample than so many mean distances know nothing

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Resampler {
  const std::vector<Sample>& samples;  ///< by rising angle
  const ScanOptions& options;
  double increment;
  double most_apart;

  /// `index` may be one before the first and one behind the last: the other end, a revolution away.
  Sample at(std::ptrdiff_t index) const {
    const auto size = static_cast<std::ptrdiff_t>(samples.size());
    Sample sample = samples[static_cast<std::size_t>((index + size) % size)];
    if (index < 0) sample.angle -= kTwoPi;
    if (index >= size) sample.angle += kTwoPi;
    return sample;
  }

  float judged(double range) const {
    if (range <= 0.0) return options.no_return == NoReturn::free ? kInfinity : kNan;
    if (range < options.range_min) return -kInfinity;
    return range > options.range_max ? kInfinity : static_cast<float>(range);
  }

  static bool same_surface(const Sample& a, const Sample& b) {
    if (a.range <= 0.0F || b.range <= 0.0F) return false;
    return std::abs(a.range - b.range) <= kSlant * std::min(a.range, b.range) * (b.angle - a.angle);
  }

  /// `after`: the first sample at or behind the angle. [m]; 0: nothing measured; nothing: nobody looked
  /// there.
  std::optional<double> range_at(double angle, std::ptrdiff_t after) const {
    const Sample low = at(after - 1);
    const Sample high = at(after);
    const bool is_low_nearer = angle - low.angle < high.angle - angle;
    const Sample& nearest = is_low_nearer ? low : high;
    if (std::abs(nearest.angle - angle) > most_apart) return std::nullopt;
    double range = nearest.range;
    if (high.angle > low.angle && high.angle - low.angle <= 2.0 * most_apart && same_surface(low, high)) {
      const double share = (angle - low.angle) / (high.angle - low.angle);
      range = 1.0 / ((1.0 - share) / low.range + share / high.range);
    }
    return nearer_within_width(angle, after, range);
  }

  /// What stands well before `range` in the beam's own width.
  double nearer_within_width(double angle, std::ptrdiff_t after, double range) const {
    const auto size = static_cast<std::ptrdiff_t>(samples.size());
    for (const int step : {-1, 1}) {
      for (std::ptrdiff_t i = step < 0 ? after - 1 : after; i >= -1 && i <= size; i += step) {
        const Sample sample = at(i);
        if (std::abs(sample.angle - angle) > increment / 2.0) break;
        const bool is_before = range <= 0.0 || sample.range < range - kSlant * sample.range * increment;
        if (sample.range > 0.0F && is_before) range = sample.range;
      }
    }
    return range;
  }
};

}  // namespace

Scan to_scan(const Revolution& revolution, const ScanOptions& options) {
  const auto beams = static_cast<std::size_t>(options.beams);
  const double period = (revolution.next - revolution.first).to_seconds();
  Scan scan{.angle_increment = kTwoPi / static_cast<double>(beams),
            .time_increment = (revolution.is_clockwise ? -period : period) / static_cast<double>(beams),
            .scan_time = period,
            .ranges = std::vector<float>(beams, kNan),
            .qualities = std::vector<float>(beams, 0.0F)};
  // Clockwise from the rear: beam 0, at -pi, comes a revolution after the first, but for one step.
  scan.time = revolution.is_clockwise ? revolution.next : revolution.first;
  if (revolution.samples.empty()) return scan;
  std::vector<Sample> samples = revolution.samples;
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.angle < b.angle; });
  const double mean_apart = kTwoPi / static_cast<double>(samples.size());
  const Resampler resampler{samples, options, scan.angle_increment,
                            kMaxApart * std::min(mean_apart, kTwoPi / 90.0)};
  std::ptrdiff_t after = 0;
  for (std::size_t i = 0; i < beams; ++i) {
    const double angle = -std::numbers::pi + static_cast<double>(i) * scan.angle_increment;
    while (after < static_cast<std::ptrdiff_t>(samples.size()) &&
           samples[static_cast<std::size_t>(after)].angle < angle)
      ++after;
    const std::optional<double> range = resampler.range_at(angle, after);
    if (!range) continue;
    scan.ranges[i] = resampler.judged(*range);
    const Sample low = resampler.at(after - 1);
    const Sample high = resampler.at(after);
    scan.qualities[i] = angle - low.angle < high.angle - angle ? low.quality : high.quality;
  }
  return scan;
}

}  // namespace bw::laser
