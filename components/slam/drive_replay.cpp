#include "components/slam/drive_replay.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>

#include "components/model/sweep_motion.hpp"

namespace bw::slam {
namespace {

constexpr double kLongestGap = 1.0;  // [s] between two odometry messages, over which a pose is interpolated

class OdometryAt {
 public:
  explicit OdometryAt(const std::vector<OdometrySample>& samples) : samples_(samples) {}

  std::optional<Pose2> operator()(Time time) const {
    const auto after = std::lower_bound(samples_.begin(), samples_.end(), time,
                                        [](const OdometrySample& sample, Time t) { return sample.time < t; });
    if (after == samples_.end()) return std::nullopt;
    if (after->time == time) return after->X_OB;
    if (after == samples_.begin()) return std::nullopt;
    const OdometrySample& before = *(after - 1);
    const double gap = (after->time - before.time).to_seconds();
    if (gap > kLongestGap) return std::nullopt;
    return pose_between(before.X_OB, after->X_OB, (time - before.time).to_seconds() / gap);
  }

 private:
  const std::vector<OdometrySample>& samples_;
};

// The scanner on the base, and whether it hangs upside down: then its angles turn the other way.
struct Mount {
  Pose2 X_BL;
  bool upside_down = false;
};

std::optional<Mount> mount_of(const RecordedDrive& drive, const std::string& frame) {
  Mount mount;
  if (frame.empty() || frame == "base_link") return mount;
  for (const FrameMount& m : drive.mounts) {
    if (m.child != frame) continue;
    const double x = m.rotation.x();
    const double y = m.rotation.y();
    const double z = m.rotation.z();
    const double w = m.rotation.w();
    // The scanner's x axis, seen from above, and where its z axis points.
    mount.X_BL = {m.translation.x(), m.translation.y(),
                  std::atan2(2.0 * (x * y + w * z), 1.0 - 2.0 * (y * y + z * z))};
    mount.upside_down = 1.0 - 2.0 * (x * x + y * y) < 0.0;
    return mount;
  }
  return std::nullopt;
}

}  // namespace

SlamReplay replay(const RecordedDrive& drive, const SlamOptions& options, const SlamProgress& progress) {
  if (drive.scans.empty()) throw std::runtime_error("the drive has no laser scans");
  if (drive.odometry.empty()) throw std::runtime_error("the drive has no odometry");
  SlamReplay result(options);
  const OdometryAt odometry(drive.odometry);
  std::map<std::string, std::size_t> dropped;
  for (std::size_t n = 0; n < drive.scans.size(); ++n) {
    if (progress && !progress(n, drive.scans.size())) break;
    const ScanSample& sample = drive.scans[n];
    const std::optional<Mount> mount = mount_of(drive, sample.frame);
    LaserSweep sweep;
    const double half =
        0.5 * static_cast<double>(sample.geometry.time_increment) * static_cast<double>(sample.ranges.size());
    sweep.time = sample.time + Duration::seconds(half);
    sweep.angle_min = static_cast<double>(sample.geometry.angle_min);
    sweep.angle_increment = static_cast<double>(sample.geometry.angle_increment);
    sweep.time_increment = static_cast<double>(sample.geometry.time_increment);
    sweep.range_min = static_cast<double>(sample.geometry.range_min);
    sweep.range_max = static_cast<double>(sample.geometry.range_max);
    sweep.ranges = sample.ranges;
    if (mount) {
      sweep.X_FL = mount->X_BL;
      if (mount->upside_down) {
        sweep.angle_min = -sweep.angle_min;
        sweep.angle_increment = -sweep.angle_increment;
      }
    } else {
      ++dropped["frame " + sample.frame + " has no transform to base_link: taken as if it were there"];
    }
    if (const SweepFault fault = fault_of(sweep); fault != SweepFault::none) {
      ++dropped[std::string("scans left out: ") + to_text(fault)];
      continue;
    }
    const std::optional<Pose2> X_OB = odometry(sweep.time);
    if (!X_OB) {
      ++dropped["scans left out: no odometry at their time"];
      continue;
    }
    const Pose2 X_BO = inverse(*X_OB);
    const std::vector<Pose2> poses = beam_poses(sweep, sweep.X_FL, [&](Time t) -> std::optional<Pose2> {
      const std::optional<Pose2> X = odometry(t);
      return X ? std::optional<Pose2>(X_BO * *X) : std::nullopt;
    });
    sweep.beam_poses = poses;
    const Tracked tracked = result.slam.add(scan_of(sweep, options), *X_OB);
    while (result.slam.advance()) {
    }
    result.scans.push_back({sweep.time, tracked.placement, result.slam.pose(tracked.placement), *X_OB});
  }
  result.slam.finish();
  for (const auto& [what, times] : dropped) result.left_out.push_back(std::to_string(times) + " " + what);
  return result;
}

}  // namespace bw::slam
