// Where the robot is among what it saw last: each scan against the submap under way, with odometry as the prior.
#pragma once

#include <optional>

#include "components/slam/odometry_trust.hpp"
#include "components/slam/refinement.hpp"
#include "components/slam/submap.hpp"

namespace bw::slam {

struct Tracked {
  Placement placement;
  UncertainPose X_SB;    ///< in placement.submap
  Refined match;         ///< zeros for the first scan
  bool matched = false;  ///< else by odometry alone
  bool enters_map = false;
  std::optional<Submap> finished;  ///< placement is in it still; later ones are in the next
};

class ScanTracking {
 public:
  explicit ScanTracking(const SlamOptions& options) : options_(options) {}

  /// Scans in order of time; X_OB by odometry at the scan's time. `nodes`: how many entered the map before.
  Tracked add(const Scan& scan, const Pose2& X_OB, std::size_t nodes);
  /// Submaps under way, as if they were finished; nothing is under way any more.
  std::vector<Submap> finish(std::size_t nodes);
  /// X_PS of submaps first to last, of those under way.
  std::vector<UncertainPose> under_way(std::size_t first, std::size_t last) const;

  const OdometryTrust& trust() const { return trust_; }

 private:
  struct Active {
    explicit Active(double resolution) : surface(resolution) {}
    SurfaceMap surface;
    UncertainPose X_SB;
    Pose2 X_before;
    UncertainPose X_PS;
    double travel = 0.0;  ///< [m], with turns as so much travel
    std::size_t first_node = 0;
  };
  Active begun(std::size_t node, const UncertainPose& X_PS) const;
  struct Match {
    Refined refined;
    UncertainPose prior;
  };
  Match match(const Scan& scan, const UncertainPose& predicted);

  SlamOptions options_;
  std::size_t submap_ = 0;  ///< number of older_
  std::optional<Active> older_;
  std::optional<Active> younger_;
  Pose2 X_OB_;
  OdometryTrust trust_;
  Time time_;
  Pose2 step_before_;
  Pose2 odometry_before_;           ///< the last step by odometry
  bool late_ = false;               ///< odometry stood still or jumped
  double since_node_ = 0.0;         ///< [m]
  double turned_since_node_ = 0.0;  ///< [rad]
};

}  // namespace bw::slam
