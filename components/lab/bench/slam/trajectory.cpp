#include "components/lab/bench/slam/trajectory.hpp"

#include <algorithm>

#include "components/model/sweep_motion.hpp"

namespace bw::slam {
namespace {

Duration apart(Time a, Time b) { return a < b ? b - a : a - b; }

double share(Time from, Time time, Time to) { return (time - from).to_seconds() / (to - from).to_seconds(); }

/// Index of the element whose time is nearest; the list is not empty.
template <class Sample>
std::size_t nearest(const std::vector<Sample>& samples, Time time) {
  const auto after = std::ranges::lower_bound(samples, time, {}, &Sample::time);
  if (after == samples.begin()) return 0;
  const auto i = static_cast<std::size_t>(after - samples.begin());
  const bool is_before =
      after == samples.end() || apart(samples[i - 1].time, time) <= apart(after->time, time);
  return is_before ? i - 1 : i;
}

Pose2 pose_of(const SlamReplay& replayed, std::size_t scan, Told told) {
  switch (told) {
    case Told::at_the_end:
      return replayed.pose(scan);
    case Told::at_the_time:
      return replayed.scans[scan].told;
    case Told::by_odometry:
      break;
  }
  return replayed.scans[scan].X_OB;
}

}  // namespace

Trajectory::Trajectory(const SlamReplay& replayed, const std::vector<OdometrySample>& odometry, Told told)
    : replayed_(replayed), odometry_(odometry) {
  for (std::size_t k = 0; k < replayed.scans.size(); ++k) poses_.push_back(pose_of(replayed, k, told));
}

std::optional<Pose2> Trajectory::at(Time time) const {
  if (poses_.empty()) return std::nullopt;
  const std::vector<ReplayedScan>& scans = replayed_.scans;
  if (const std::optional<Pose2> pose = of_scan(time)) return pose;
  const std::size_t k = nearest(scans, time);
  const Duration distance = apart(scans[k].time, time);
  const std::size_t next = scans[k].time < time ? k + 1 : k;
  if (next > 0 && next < scans.size() && scans[next].time - scans[next - 1].time <= kShortGap)
    return pose_between(poses_[next - 1], poses_[next], share(scans[next - 1].time, time, scans[next].time));
  const std::optional<Pose2> X_OB = odometry_at(odometry_, time, kShortGap);
  if (!X_OB || distance > kFarthest) return std::nullopt;
  return poses_[k] * (inverse(scans[k].X_OB) * *X_OB);
}

std::optional<Pose2> Trajectory::of_scan(Time time) const {
  if (poses_.empty()) return std::nullopt;
  const std::size_t k = nearest(replayed_.scans, time);
  if (apart(replayed_.scans[k].time, time) > kSameStamp) return std::nullopt;
  return poses_[k];
}

}  // namespace bw::slam
