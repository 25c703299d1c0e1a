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
  /// Scans in a row, this one among them, that do not meet the map though one just before did and the robot
  /// hardly moved by odometry since: somebody carried it away. None of them enters the map. 0 unless
  /// SlamOptions::holds_back.
  int held = 0;
  Pose2 by_odometry;               ///< the step from the scan before
  Pose2 by_scan;                   ///< the same with what the scan says
  std::optional<Submap> finished;  ///< placement is in it still; later ones are in the next
};

/// Points of a scan; fewer say nothing of where the robot is.
inline constexpr std::size_t kFewPoints = 30;

class ScanTracking {
 public:
  /// All of it between two scans, but which of them are held back.
  struct State {
    struct Active {
      SurfaceMap::State surface;
      UncertainPose X_SB;
      Pose2 X_before;
      std::optional<std::size_t> found_in;
      UncertainPose X_PS;
      double travel = 0.0;
      std::size_t first_node = 0;
    };
    std::size_t submap = 0;
    std::optional<Active> older;
    std::optional<Active> younger;
    Pose2 X_OB;
    double travel_factor = 0.0;  ///< OdometryTrust
    double turn_factor = 0.0;
    Time time;
    Pose2 step_before;
    Pose2 odometry_before;
    bool late = false;
    double since_node = 0.0;
    double turned_since_node = 0.0;
  };

  explicit ScanTracking(const SlamOptions& options) : options_(options) {}
  ScanTracking(const SlamOptions& options, const State& state);
  State state() const;

  /// Scans in order of time; X_OB by odometry at the scan's time. `nodes`: how many entered the map before.
  Tracked add(const Scan& scan, const Pose2& X_OB, std::size_t nodes);
  /// Submaps under way, as if they were finished; nothing is under way any more.
  std::vector<Submap> finish(std::size_t nodes);
  /// With nothing under way: the next scan begins a submap at X_PB in submap `found_in`.
  void begin_at(std::size_t found_in, const UncertainPose& X_PB);

  struct Joint {
    std::optional<std::size_t> found_in;  ///< as Submap's
    UncertainPose X_PS;
  };
  /// How a submap hangs on its parent, if it is under way.
  std::optional<Joint> joint(std::size_t submap) const;
  /// Number of the submap that scans are matched against, and its walls; null before the first scan.
  std::size_t submap() const { return submap_; }
  const SurfaceMap* walls() const { return older_ ? &older_->surface : nullptr; }

  const OdometryTrust& trust() const { return trust_; }

 private:
  struct Active {
    explicit Active(double resolution) : surface(resolution) {}
    Active(double resolution, const State::Active& state);
    State::Active state() const;
    Submap finished(std::size_t nodes) const;
    SurfaceMap surface;
    UncertainPose X_SB;
    Pose2 X_before;
    Joint joint;
    double travel = 0.0;  ///< [m], with turns as so much travel
    std::size_t first_node = 0;
  };
  Active begun(std::size_t node, const Joint& joint) const;
  struct Match {
    Refined refined;
    UncertainPose prior;
  };
  Match match(const Scan& scan, const UncertainPose& predicted);
  /// Tracked::held of a scan that meets the map with this share.
  int held(const Scan& scan, const Pose2& X_OB, double inliers);

  SlamOptions options_;
  std::size_t submap_ = 0;  ///< number of older_
  std::optional<Active> older_;
  std::optional<Active> younger_;
  Joint start_;  ///< of the next submap, if nothing is under way
  Pose2 X_OB_;
  OdometryTrust trust_;
  Time time_;
  Pose2 step_before_;
  Pose2 odometry_before_;          ///< the last step by odometry
  bool late_ = false;              ///< odometry stood still or jumped
  std::optional<Pose2> met_X_OB_;  ///< of the newest scan that met the map
  int held_ = 0;
  double since_node_ = 0.0;         ///< [m]
  double turned_since_node_ = 0.0;  ///< [rad]
};

}  // namespace bw::slam
