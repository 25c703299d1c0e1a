#include "components/lab/experiments/localization_replay.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bw {
namespace {

using namespace localization;

enum Source { kWheels, kGyro, kCompass, kReceiver, kRanges };

/// Makes entries of a log into measurements.
class Feed {
 public:
  Feed(const RecordedDrive& drive, const ReplaySensors& sensors, Localizer& filter)
      : drive_(drive), sensors_(sensors), filter_(filter) {
    if (drive.fixes.empty()) return;
    plane_ = LocalPlane::around(drive.datum);
    if (!plane_) throw std::invalid_argument("the datum of the log is no place on earth");
  }

  void operator()(const OdometrySample* sample) {
    if (before_ != nullptr) {
      WheelStep step = step_between(drive_, *before_, *sample, sensors_.wheel_noise);
      step.source = kWheels;
      add(step);
    }
    before_ = sample;
  }

  void operator()(const ImuSample* sample) {
    const auto variance = [](double declared, double sigma) {
      return declared > 0.0 ? declared : sigma * sigma;
    };
    if (sensors_.gyro && sample->turn_rate)
      add(GyroReading{sample->time, kGyro, *sample->turn_rate, variance(0.0, sensors_.gyro_noise)});
    if (!sensors_.compass || !sample->heading) return;
    if (sensors_.compass_after_start && !filter_.initialised()) return;
    add(HeadingReading{sample->time, kCompass, *sample->heading,
                       variance(sample->heading_variance, sensors_.compass_noise)});
  }

  void operator()(const FixSample* sample) {
    if (!sensors_.receiver) return;
    if (sample->variance.isZero()) throw std::invalid_argument("the log declares no variance of its fixes");
    PositionFix fix;
    fix.time = sample->time;
    fix.source = kReceiver;
    fix.position = plane_->to_plane(sample->position).head<2>();
    fix.covariance = sample->variance.head<2>().asDiagonal();
    add(fix);
  }

  void operator()(const RangeSample* sample) {
    if (!sensors_.ranges) return;
    RangeReading range;
    range.time = sample->time;
    range.source = kRanges;
    range.range = sample->range;
    range.variance = sample->variance;
    range.anchor = sample->anchor;
    add(range);
  }

  void operator()(const ScanSample*) {}
  void operator()(const ReferencePose*) {}

 private:
  void add(const Measurement& measurement) { filter_.add(measurement, stamp(measurement)); }

  const RecordedDrive& drive_;
  const ReplaySensors& sensors_;
  Localizer& filter_;
  std::optional<LocalPlane> plane_;
  const OdometrySample* before_ = nullptr;
};

}  // namespace

ReplayErrors errors_of(const std::vector<ReplayPoint>& points) {
  ReplayErrors errors{.count = points.size()};
  double squares = 0.0;
  for (const ReplayPoint& point : points) {
    errors.mean += point.error / static_cast<double>(points.size());
    squares += point.error * point.error / static_cast<double>(points.size());
    errors.largest = std::max(errors.largest, point.error);
  }
  errors.rms = std::sqrt(squares);
  return errors;
}

ReplayResult replay(const RecordedDrive& drive, const ReplaySensors& sensors,
                    const std::vector<Checkpoint>& checkpoints, Localizer& filter) {
  ReplayResult result;
  Feed feed(drive, sensors, filter);
  auto next = checkpoints.begin();
  const auto compare = [&](const Checkpoint& checkpoint) {
    if (!filter.initialised()) return;
    const Vector2 position = filter.estimate_at(checkpoint.time).X_MB.position();
    result.points.push_back({checkpoint.time, position, (position - checkpoint.position).norm()});
  };
  for (const RecordedEvent& event : in_time_order(drive)) {
    for (; next != checkpoints.end() && next->time < stamp(event); ++next) compare(*next);
    std::visit(feed, event);
    if (!result.first_pose && filter.initialised()) result.first_pose = stamp(event);
  }
  for (; next != checkpoints.end(); ++next) compare(*next);
  if (filter.initialised()) result.last = filter.estimate_at(Time{INT64_MAX / 4});
  return result;
}

std::vector<Checkpoint> reference_checkpoints(const RecordedDrive& drive) {
  std::vector<Checkpoint> checkpoints;
  for (const ReferencePose& reference : drive.truth)
    checkpoints.push_back({reference.time, reference.position});
  return checkpoints;
}

std::vector<Checkpoint> fix_checkpoints(const std::vector<FixSample>& fixes, const Geodetic& datum) {
  const auto plane = LocalPlane::around(datum);
  if (!plane) throw std::invalid_argument("the datum is no place on earth");
  std::vector<Checkpoint> checkpoints;
  for (const FixSample& fix : fixes)
    checkpoints.push_back({fix.time, plane->to_plane(fix.position).head<2>()});
  return checkpoints;
}

}  // namespace bw
