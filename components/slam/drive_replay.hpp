// A recorded drive through SLAM, as fast as it goes.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "components/recordings/recorded_drive.hpp"
#include "components/slam/slam.hpp"

namespace bw::slam {

/// One scan of the drive.
struct ReplayedScan {
  Time time;
  Placement placement;
  Pose2 told;                                            ///< X_MB as it was told at the time
  Pose2 X_OB;                                            ///< by odometry
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of `told`, relative to the first pose
};

struct SlamReplay {
  explicit SlamReplay(const SlamOptions& options) : slam(options) {}
  Slam slam;
  std::vector<ReplayedScan> scans;
  std::vector<std::string>
      left_out;  ///< sentences: what of the drive was not used, how often, and what to do
  /// By the clock that was given, in its unit: of each scan, from its ranges to its pose; of each piece of
  /// work on loops; of work with the whole graph, which a robot does beside its scans.
  std::vector<double> scan_times;
  std::vector<double> piece_times;
  std::vector<double> graph_times;

  /// X_MB of a scan, with all that is known at the end.
  Pose2 pose(std::size_t scan) const { return slam.pose(scans[scan].placement); }
};

/// Called before each scan: how many are done, of how many. False ends the replay there, as if the drive
/// ended.
using SlamProgress = std::function<bool(std::size_t, std::size_t)>;

struct ReplayHooks {
  SlamProgress progress;
  /// Time by which the work is measured, such as that of the processor.
  std::function<double()> clock;
  /// Called after each scan and the work on loops that it made: what is known then.
  std::function<void(const SlamReplay&)> after_scan;
};

/// Scans whose time odometry covers; each beam at its time (sweep_motion.hpp). Where a scanner sits on
/// base_link (or on base_footprint, if there is none) is told by the drive's mounts, one upon the other.
/// Throws std::runtime_error where the drive has no scans or no odometry.
SlamReplay replay(const RecordedDrive& drive, const SlamOptions& options, const ReplayHooks& hooks = {});

/// Another drive in the same place: the robot is looked for in the map (relocalization.hpp), scans until it
/// is found are left out, and from there on the map grows. Its scans follow those that are there, a minute
/// later. False: it was not found, and the map is as it was. Throws as replay().
bool replay_more(SlamReplay& so_far, const RecordedDrive& drive, const SlamOptions& options,
                 const ReplayHooks& hooks = {});

}  // namespace bw::slam
