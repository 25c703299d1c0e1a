#include "components/recordings/recorded_drive.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/differential_drive.hpp"
#include "components/model/sweep_motion.hpp"

namespace bw {

WheelStep step_between(const RecordedDrive& drive, const OdometrySample& from, const OdometrySample& to,
                       double variance_per_metre) {
  const Duration over = to.time - from.time;
  const double b = drive.wheel_separation;
  WheelStep step = step_from_poses(to.time, over, from.X_OB, to.X_OB, b, variance_per_metre);
  if (drive.wheel_variance > 0.0) {  // of both speeds, held for the step
    const double variance = drive.wheel_variance * std::pow(over.to_seconds(), 2);
    step.covariance << variance / 2.0, 0.0, 0.0, 2.0 * variance / (b * b);
  }
  return step;
}

Time count_from(std::optional<Time> start, RecordedDrive& drive) {
  const auto each = [&drive](const auto& action) {
    for (auto& sample : drive.odometry) action(sample.time);
    for (auto& sample : drive.imu) action(sample.time);
    for (auto& sample : drive.fixes) action(sample.time);
    for (auto& sample : drive.ranges) action(sample.time);
    for (auto& sample : drive.scans) action(sample.time);
    for (auto& sample : drive.truth) action(sample.time);
  };
  if (!start) each([&start](const Time& time) { start = std::min(start.value_or(time), time); });
  if (!start) return {};
  const Duration before = *start - Time{};
  each([before](Time& time) { time = time - before; });
  return *start;
}

OdometrySample advance(const OdometrySample& sample, const Twist2& twist, Time time) {
  return {time, advance_exact(sample.X_OB, twist, (time - sample.time).to_seconds()), twist};
}

std::optional<Pose2> odometry_at(const std::vector<OdometrySample>& odometry, Time time, Duration longest) {
  const auto after = std::ranges::lower_bound(odometry, time, {}, &OdometrySample::time);
  if (after == odometry.end()) return std::nullopt;
  if (after->time == time) return after->X_OB;
  if (after == odometry.begin()) return std::nullopt;
  const OdometrySample& before = *(after - 1);
  const Duration gap = after->time - before.time;
  if (gap > longest) return std::nullopt;
  return pose_between(before.X_OB, after->X_OB, (time - before.time).to_seconds() / gap.to_seconds());
}

std::optional<ReferencePose> reference_at(const RecordedDrive& drive, Time time, Duration longest) {
  const auto after =
      std::lower_bound(drive.truth.begin(), drive.truth.end(), time,
                       [](const ReferencePose& reference, Time t) { return reference.time < t; });
  if (after == drive.truth.end()) return std::nullopt;
  if (after->time == time) return *after;
  if (after == drive.truth.begin()) return std::nullopt;
  const ReferencePose& before = *(after - 1);
  const Duration gap = after->time - before.time;
  if (gap > longest) return std::nullopt;
  const double part = (time - before.time).to_seconds() / gap.to_seconds();
  ReferencePose reference{time, before.position + part * (after->position - before.position), {}};
  if (before.heading && after->heading)
    reference.heading = wrap_angle(*before.heading + part * wrap_angle(*after->heading - *before.heading));
  return reference;
}

Twist2 twist_between(const ReferencePose& from, const ReferencePose& to) {
  const double dt = (to.time - from.time).to_seconds();
  if (dt <= 0.0 || !from.heading || !to.heading) return {};
  const auto pose = [](const ReferencePose& r) { return Pose2{r.position.x(), r.position.y(), *r.heading}; };
  const ArcTravel arc = arc_between(pose(from), pose(to));
  return {arc.distance / dt, arc.rotation / dt};
}

std::vector<RecordedEvent> in_time_order(const RecordedDrive& drive) {
  std::vector<RecordedEvent> events;
  const auto add = [&events](const auto& samples) {
    for (const auto& sample : samples) events.emplace_back(&sample);
  };
  add(drive.odometry);
  add(drive.imu);
  add(drive.fixes);
  add(drive.ranges);
  add(drive.scans);
  add(drive.truth);
  std::stable_sort(events.begin(), events.end(),
                   [](const RecordedEvent& a, const RecordedEvent& b) { return stamp(a) < stamp(b); });
  return events;
}

std::vector<RecordedEvent> events_between(const RecordedDrive& drive, double start, double end) {
  std::vector<RecordedEvent> events = in_time_order(drive);
  std::erase_if(events, [&](const RecordedEvent& event) {
    const double t = stamp(event).to_seconds();
    return t < start || (end != 0.0 && t > end);
  });
  return events;
}

}  // namespace bw
