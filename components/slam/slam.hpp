// Simultaneous localization and mapping: scans and odometry in; where the robot was, and a map, out.
//
// Frames: M the map, whose origin is the pose of the first scan; S a submap; B base_link; O odom.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>
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
  std::size_t nodes = 0;       ///< that entered the map, also those that left it since
};

/// All that SLAM knows between two scans: what a graph file holds (graph_file.md).
struct SlamState {
  SlamOptions options;
  SlamCounts counts;
  std::vector<std::pair<std::size_t, Node>> nodes;  ///< with their numbers, which count up
  LoopClosing::State closing;
  ScanTracking::State tracking;
};

/// Pieces of the work on loops for each scan, where none may be delayed: at 10 scans/s a submap's are done before the
/// next comes.
inline constexpr int kPiecesPerScan = 2;

class Slam {
 public:
  explicit Slam(const SlamOptions& options);
  /// Goes on where save() was called: what is added next is told as if there had been no break.
  explicit Slam(SlamState state);
  /// All that is known; what is left of the work on loops is done first.
  SlamState save();
  /// Ends the drive so far. The next scan, wherever odometry counts from, begins at X_PB in submap `found_in`
  /// (relocalization.hpp), one of those taken up.
  void begin_at(std::size_t found_in, const UncertainPose& X_PB);

  /// A scan and where odometry was at its time, in order of time.
  Tracked add(const Scan& scan, const Pose2& X_OB);
  /// A piece of the work on loops and the graph, of which some tens come up every half submap. False: none is
  /// left.
  bool advance() { return closing_.advance(); }
  /// As LoopClosing's.
  void work_beside(LoopClosing::Beside beside) { closing_.work_beside(std::move(beside)); }
  /// Ends the drive: what is under way becomes submaps, and all work is done.
  void finish();

  /// X_MB of a scan that was added, with all that is known by now.
  Pose2 pose(const Placement& placement) const;
  /// Covariance of (x, y, theta) of a scan's pose in the map, relative to the first.
  Eigen::Matrix3d covariance(const Tracked& tracked) const;
  const Nodes& nodes() const { return *nodes_; }
  const std::vector<Edge>& edges() const { return closing_.edges(); }
  /// Counts up whenever poses of earlier scans moved, or submaps left.
  std::int64_t revision() const { return closing_.revision(); }
  const SlamCounts& counts() const { return counts_; }
  const LoopCounts& loop_counts() const { return closing_.counts(); }
  const OdometryTrust& trust() const { return tracking_.trust(); }
  std::size_t submaps() const { return closing_.X_MS().size(); }
  /// Those that were taken up, and their poses.
  const std::vector<Submap>& map() const { return closing_.submaps(); }
  const std::vector<Pose2>& X_MS() const { return closing_.X_MS(); }
  const SlamOptions& options() const { return options_; }
  /// The submap that scans are matched against: its number, and its walls, null before the first scan.
  std::size_t submap_under_way() const { return tracking_.submap(); }
  const SurfaceMap* walls_under_way() const { return tracking_.walls(); }

  /// As advance(), and poses move for loops that waited, too. False: all is settled.
  bool settle_a_piece();
  void settle() {
    while (settle_a_piece()) closing_.wait();
  }

 private:
  std::optional<ScanTracking::Joint> joint(std::size_t submap) const;
  Pose2 X_M(std::size_t submap) const;

  SlamOptions options_;
  ScanTracking tracking_;
  std::unique_ptr<Nodes> nodes_;
  LoopClosing closing_;
  SlamCounts counts_;
};

}  // namespace bw::slam
