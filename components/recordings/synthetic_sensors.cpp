#include "components/recordings/synthetic_sensors.hpp"

#include <algorithm>
#include <stdexcept>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr Duration kLongestGap = Duration::milliseconds(500);
constexpr std::uint64_t kCompassStream = 0x9e3779b97f4a7c15;

/// Calls `measure` with the reference at every period while wheels and reference are heard.
template <class Measure>
void at_rate(const RecordedDrive& drive, double rate, const Measure& measure) {
  if (rate <= 0.0 || drive.odometry.empty() || drive.truth.empty()) return;
  const Time last = std::min(drive.odometry.back().time, drive.truth.back().time);
  for (std::int64_t i = 1;; ++i) {
    const Time time = drive.odometry.front().time + Duration::seconds(static_cast<double>(i) / rate);
    if (time > last) return;
    if (const auto reference = reference_at(drive, time, kLongestGap)) measure(*reference);
  }
}

template <class Sample>
void sort_by_stamp(std::vector<Sample>& samples) {
  std::stable_sort(samples.begin(), samples.end(),
                   [](const Sample& a, const Sample& b) { return a.time < b.time; });
}

}  // namespace

void add_synthetic_sensors(RecordedDrive& drive, const SyntheticSensorOptions& options,
                           const localization::Geodetic& datum, std::uint64_t seed) {
  const auto plane = localization::LocalPlane::around(datum);
  if (!plane) throw std::invalid_argument("the datum is no place on earth");
  drive.datum = datum;
  Random receiver(seed);
  at_rate(drive, options.gps_rate, [&](const ReferencePose& at) {
    const double east = at.position.x() + options.gps_noise * receiver.normal();
    const double north = at.position.y() + options.gps_noise * receiver.normal();
    const double variance = options.gps_noise * options.gps_noise;
    drive.fixes.push_back({at.time, plane->to_geodetic({east, north, 0.0}), {variance, variance, variance}});
  });
  Random compass(seed ^ kCompassStream);
  at_rate(drive, options.compass_rate, [&](const ReferencePose& at) {
    if (!at.heading) return;
    const double noise = options.compass_noise;
    drive.imu.push_back({at.time, wrap_angle(*at.heading + noise * compass.normal()), {}, noise * noise});
  });
  sort_by_stamp(drive.fixes);
  sort_by_stamp(drive.imu);
}

}  // namespace bw
