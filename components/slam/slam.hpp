// Simultaneous localization and mapping: scans and odometry in; where the robot was, and a map, out.
//
// Frames: M the map, whose origin is the pose of the first scan; S a submap; B base_link; O odom.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "components/slam/loop_closing.hpp"
#include "components/slam/scan.hpp"
#include "components/slam/scan_tracking.hpp"
#include "components/slam/slam_options.hpp"
#include "components/slam/submap.hpp"

namespace bw::slam {

struct SlamCounts {
  std::int64_t scans = 0;
  std::int64_t unmatched = 0;  ///< by odometry alone
};

class Slam {
 public:
  explicit Slam(const SlamOptions& options);

  /// A scan and where odometry was at its time, in order of time.
  Tracked add(const Scan& scan, const Pose2& X_OB);
  /// A piece of the work on loops and the graph, of which some tens come up every half submap. False: none is
  /// left.
  bool advance() { return closing_.advance(); }
  /// Ends the drive: what is under way becomes submaps, and all work is done.
  void finish();

  /// X_MB of a scan that was added, with all that is known by now.
  Pose2 pose(const Placement& placement) const;
  /// Covariance of (x, y, theta) of a scan's pose in the map, relative to the first.
  Eigen::Matrix3d covariance(const Tracked& tracked) const;
  /// Scans of the map, in order of time; those that are there do not move in memory.
  const std::deque<Node>& nodes() const { return *nodes_; }
  const std::vector<Loop>& loops() const { return closing_.loops(); }
  /// Counts up whenever poses of earlier scans moved.
  std::int64_t revision() const { return closing_.revision(); }
  const SlamCounts& counts() const { return counts_; }
  const LoopCounts& loop_counts() const { return closing_.counts(); }
  const OdometryTrust& trust() const { return tracking_.trust(); }
  std::size_t submaps() const { return closing_.X_MS().size(); }
  /// Submaps and their poses, to which loops refer.
  const LoopClosing& loop_closing() const { return closing_; }

 private:
  ScanTracking tracking_;
  std::unique_ptr<std::deque<Node>> nodes_;
  LoopClosing closing_;
  SlamCounts counts_;
};

}  // namespace bw::slam
