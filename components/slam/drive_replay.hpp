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
  Pose2 told;  ///< X_MB as it was told at the time
  Pose2 X_OB;  ///< by odometry
};

struct SlamReplay {
  explicit SlamReplay(const SlamOptions& options) : slam(options) {}
  Slam slam;
  std::vector<ReplayedScan> scans;
  std::vector<std::string>
      left_out;  ///< sentences: what of the drive was not used, how often, and what to do

  /// X_MB of a scan, with all that is known at the end.
  Pose2 pose(std::size_t scan) const { return slam.pose(scans[scan].placement); }
};

/// Called before each scan: how many are done, of how many. False ends the replay there.
using SlamProgress = std::function<bool(std::size_t, std::size_t)>;

/// Scans whose time odometry covers; each beam at its time (sweep_motion.hpp).
/// Throws std::runtime_error where the drive has no scans or no odometry.
SlamReplay replay(const RecordedDrive& drive, const SlamOptions& options, const SlamProgress& progress = {});

}  // namespace bw::slam
