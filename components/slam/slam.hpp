// Simultaneous localization and mapping: scans and odometry in; where the robot was, and a map, out.
//
// Frames: M the map, whose origin is the pose of the first scan; S a submap; B base_link; O odom.
#pragma once

#include <cstdint>
#include <vector>

#include "components/slam/loop_search.hpp"
#include "components/slam/pose_graph.hpp"
#include "components/slam/scan.hpp"
#include "components/slam/scan_tracking.hpp"
#include "components/slam/slam_options.hpp"
#include "components/slam/submap.hpp"

namespace bw::slam {

struct SlamCounts {
  std::int64_t scans = 0;
  std::int64_t unmatched = 0;  ///< by odometry alone
  std::int64_t searched = 0;   ///< pairs of submaps
  std::int64_t found = 0;      ///< loops
  std::int64_t accepted = 0;
  std::int64_t visited = 0;  ///< poses and squares of branch and bound
  std::int64_t optimisations = 0;
};

class Slam {
 public:
  explicit Slam(const SlamOptions& options);

  /// A scan and where odometry was at its time, in order of time.
  Tracked add(const Scan& scan, const Pose2& X_OB);
  /// Ends the drive: what is under way becomes submaps, and loops are searched for the last time.
  void finish();

  /// X_MB of a scan that was added, with all that is known by now.
  Pose2 pose(const Placement& placement) const;
  const std::vector<Node>& nodes() const { return nodes_; }
  const std::vector<Loop>& loops() const { return accepted_; }
  const SlamCounts& counts() const { return counts_; }
  const OdometryTrust& trust() const { return tracking_.trust(); }
  std::size_t submaps() const { return submaps_.size(); }

 private:
  void take(const Submap& submap);
  /// Submaps that `later` may have seen again; others: their poses in it.
  std::vector<std::size_t> loop_candidates(std::size_t later, const std::vector<UncertainPose>& others);
  void search(std::size_t later);
  bool accept();

  SlamOptions options_;
  ScanTracking tracking_;
  std::vector<Node> nodes_;
  std::vector<Submap> submaps_;
  std::vector<Pose2> X_MS_;
  std::vector<Edge> edges_;
  std::vector<Loop> pending_;
  std::vector<Loop> accepted_;
  std::size_t turn_ = 0;  ///< of the candidates that are far
  SlamCounts counts_;
};

}  // namespace bw::slam
