#include "components/slam/drive_replay.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "components/model/sweep_motion.hpp"
#include "components/slam/relocalization.hpp"

namespace bw::slam {
namespace {

constexpr Duration kLongestGap = Duration::milliseconds(1000);  // over which odometry is interpolated

std::string seconds(Duration d) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f s", d.to_seconds());
  return text;
}

// What there is instead of odometry at `time`.
std::string around(const std::vector<OdometrySample>& odometry, Time time) {
  if (time < odometry.front().time)
    return "it begins " + seconds(odometry.front().time - time) +
           " later: start to record it before the laser";
  if (time > odometry.back().time)
    return "it ends " + seconds(time - odometry.back().time) +
           " earlier: record it to the end, with stamps of the laser's clock";
  return "it has a gap there, longer than 1 s: look why the base was silent";
}

// The scanner on the base, and whether it hangs upside down: then its angles turn the other way.
struct Mount {
  Pose2 X_BL;
  bool upside_down = false;
};

bool is_base(const std::string& frame) {
  return frame.empty() || frame == "base_link" || frame == "base_footprint";
}

std::optional<Mount> mount_of(const RecordedDrive& drive, const std::string& frame) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();  // of the scanner in `at`
  std::string at = frame;
  for (std::size_t steps = 0; !is_base(at); ++steps) {
    const auto mount = std::find_if(drive.mounts.begin(), drive.mounts.end(),
                                    [&at](const FrameMount& m) { return m.child == at; });
    if (mount == drive.mounts.end() || steps > drive.mounts.size()) return std::nullopt;
    const Eigen::Quaterniond rotation(mount->rotation.w(), mount->rotation.x(), mount->rotation.y(),
                                      mount->rotation.z());
    X = Eigen::Translation3d(mount->translation) * rotation.normalized() * X;
    at = mount->parent;
  }
  // The scanner's x axis, seen from above, and where its z axis points.
  const Eigen::Matrix3d R = X.linear();
  return Mount{{X.translation().x(), X.translation().y(), std::atan2(R(1, 0), R(0, 0))}, R(2, 2) < 0.0};
}

// What happened to scans: how often, and when first.
class Dropped {
 public:
  void add(const std::string& what, const ScanSample& scan, const std::string& advice) {
    auto [entry, is_new] = entries_.try_emplace(what);
    ++entry->second.first;
    if (!is_new) return;
    entry->second.second = "; first at " + seconds(scan.time - Time{}) + " in frame " +
                           (scan.frame.empty() ? "(without name)" : scan.frame) + ": " + advice;
  }
  std::vector<std::string> sentences() const {
    std::vector<std::string> all;
    for (const auto& [what, entry] : entries_)
      all.push_back(std::to_string(entry.first) + " " + what + entry.second);
    return all;
  }

 private:
  std::map<std::string, std::pair<std::size_t, std::string>> entries_;
};

const char* advice_for(SweepFault fault) {
  switch (fault) {
    case SweepFault::bad_angles:
      return "angle_min and angle_increment must be finite, the step not zero";
    case SweepFault::bad_limits:
      return "the driver must tell range_min and range_max of the scanner";
    case SweepFault::wrong_length:
      return "there must be two beams or more, and not more than go round once";
    default:
      return "look at the driver of the laser";
  }
}

class Replay {
 public:
  Replay(const RecordedDrive& drive, const SlamOptions& options, const ReplayHooks& hooks, SlamReplay& result)
      : drive_(drive), options_(options), hooks_(hooks), result_(result) {
    if (hooks.clock)
      result.slam.work_beside([this](const std::function<void()>& work) {
        const double before = now();
        work();
        result_.graph_times.push_back(now() - before);
        return LoopClosing::Pending{};
      });
    if (result.scans.empty()) return;
    search_ = std::make_unique<PlaceSearch>(result.slam);
    later_ = result.scans.back().time + Duration::seconds(60.0) - drive.scans.front().time;
  }

  void run() {
    for (std::size_t n = 0; n < drive_.scans.size(); ++n) {
      if (hooks_.progress && !hooks_.progress(n, drive_.scans.size())) break;
      add(drive_.scans[n]);
    }
    if (!search_) result_.slam.finish();
    result_.slam.work_beside({});
    const std::vector<std::string> sentences = dropped_.sentences();
    result_.left_out.insert(result_.left_out.end(), sentences.begin(), sentences.end());
  }
  bool is_placed() const { return search_ == nullptr; }

 private:
  void add(const ScanSample& sample) {
    const double before = now();
    const std::optional<Tracked> tracked = track(sample);
    if (!tracked) return;
    if (hooks_.clock) result_.scan_times.push_back(now() - before);
    work_on_loops();
    ReplayedScan& scan = result_.scans.back();
    scan.told = result_.slam.pose(tracked->placement);
    scan.covariance = result_.slam.covariance(*tracked);
    if (hooks_.after_scan) hooks_.after_scan(result_);
  }

  std::optional<Pose2> odometry(Time time) const { return odometry_at(drive_.odometry, time, kLongestGap); }
  double now() const { return hooks_.clock ? hooks_.clock() : 0.0; }

  std::optional<Tracked> track(const ScanSample& sample) {
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
    if (const std::optional<Mount> mount = mount_of(drive_, sample.frame)) {
      sweep.X_FL = mount->X_BL;
      if (mount->upside_down) {
        sweep.angle_min = -sweep.angle_min;
        sweep.angle_increment = -sweep.angle_increment;
      }
    } else {
      dropped_.add("scans of frame " + sample.frame + " taken as if it were base_link", sample,
                   "no transform leads there: record /tf_static with one from base_link");
    }
    if (const SweepFault fault = fault_of(sweep); fault != SweepFault::none) {
      dropped_.add(std::string("scans left out: ") + to_text(fault), sample, advice_for(fault));
      return std::nullopt;
    }
    const std::optional<Pose2> X_OB = odometry(sweep.time);
    if (!X_OB) {
      dropped_.add("scans left out: no odometry at their time", sample, around(drive_.odometry, sweep.time));
      return std::nullopt;
    }
    const Pose2 X_BO = inverse(*X_OB);
    const std::vector<Pose2> poses = beam_poses(sweep, sweep.X_FL, [&](Time t) -> std::optional<Pose2> {
      const std::optional<Pose2> X = odometry(t);
      return X ? std::optional<Pose2>(X_BO * *X) : std::nullopt;
    });
    sweep.beam_poses = poses;
    Scan scan = scan_of(sweep, options_);
    scan.time = scan.time + later_;
    if (search_ && !find_place(scan, *X_OB)) {
      dropped_.add("scans left out: the robot's place in the map was not found yet", sample,
                   "a drive that goes on with a map begins where the map is, and drives some metres");
      return std::nullopt;
    }
    Tracked tracked = result_.slam.add(scan, *X_OB);
    result_.scans.push_back({.time = scan.time, .placement = tracked.placement, .X_OB = *X_OB});
    return tracked;
  }

  bool find_place(const Scan& scan, const Pose2& X_OB) {
    search_->add(scan, X_OB);
    while (search_->advance()) {
    }
    const std::optional<Place> place = search_->place();
    if (!place) return false;
    search_.reset();
    result_.slam.begin_at(place->submap, place->X_SB);
    return true;
  }

  void work_on_loops() {
    for (bool more = true; more;) {
      const double before = now();
      const std::size_t graphs = result_.graph_times.size();
      more = result_.slam.advance();
      if (!hooks_.clock || !more) continue;
      double time = now() - before;
      if (result_.graph_times.size() > graphs) time -= result_.graph_times.back();
      result_.piece_times.push_back(time);
    }
  }

  const RecordedDrive& drive_;
  const SlamOptions& options_;
  const ReplayHooks& hooks_;
  Dropped dropped_;
  SlamReplay& result_;
  std::unique_ptr<PlaceSearch> search_;  ///< while the robot's place in the map is not known
  Duration later_;                       ///< than the stamps of the drive
};

void require_drive(const RecordedDrive& drive) {
  if (drive.scans.empty()) throw std::runtime_error("the drive has no laser scans");
  if (drive.odometry.empty()) throw std::runtime_error("the drive has no odometry");
}

}  // namespace

SlamReplay replay(const RecordedDrive& drive, const SlamOptions& options, const ReplayHooks& hooks) {
  require_drive(drive);
  SlamReplay result(options);
  Replay(drive, options, hooks, result).run();
  return result;
}

bool replay_more(SlamReplay& so_far, const RecordedDrive& drive, const SlamOptions& options,
                 const ReplayHooks& hooks) {
  require_drive(drive);
  Replay replayed(drive, options, hooks, so_far);
  replayed.run();
  return replayed.is_placed();
}

}  // namespace bw::slam
