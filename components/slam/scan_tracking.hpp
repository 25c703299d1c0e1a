// Where the robot is among what it saw last: each scan against the submap under way, with odometry as the prior.
#pragma once

#include <algorithm>
#include <cmath>
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
  /// Scans in a row, this one among them, that neither meet the map nor show what one just before showed, though the
  /// robot hardly moved by odometry since: somebody carried it away. None of them enters the map. 0 unless
  /// SlamOptions::holds_back.
  int held = 0;
  Pose2 by_odometry;               ///< the step from the scan before, as odometry has it
  Pose2 by_scan;                   ///< the same with what the scan says
  std::optional<Submap> finished;  ///< placement is in it still; later ones are in the next
};

/// Tracked::held from which on the robot is somewhere else.
inline constexpr int kKidnappedAfter = 5;
/// Points of a scan; fewer say nothing of where the robot is.
inline constexpr std::size_t kFewPoints = 30;

/// Whether odometry jumped: no base drives a step so long between two scans, of which none is 400 m.
inline bool is_jump(const Pose2& step, double seconds) {
  constexpr double kFastest = 3.0;  // [m/s]
  return std::hypot(step.x, step.y) > std::clamp(kFastest * seconds, 0.5, 400.0);
}

class ScanTracking {
 public:
  struct Joint {
    std::optional<std::size_t> found_in;  ///< as Submap's
    UncertainPose X_PS;
  };
  /// A submap under way, but for its walls.
  struct UnderWay {
    UncertainPose X_SB;
    Pose2 X_before;
    Joint joint;
    double travel = 0.0;  ///< [m], with turns as so much travel
    std::size_t first_node = 0;
  };
  struct Motion {
    std::size_t submap = 0;  ///< number of the older one under way
    Pose2 X_OB;
    OdometryTrust trust;
    Time time;
    Pose2 step_before;
    Pose2 odometry_before;           ///< the last step by odometry
    bool late = false;               ///< odometry stood still or jumped
    double since_node = 0.0;         ///< [m]
    double turned_since_node = 0.0;  ///< [rad]
  };
  /// All of it between two scans, but which of them are held back.
  struct State : Motion {
    struct Active : UnderWay {
      SurfaceMap::State surface;
    };
    std::optional<Active> older;
    std::optional<Active> younger;
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

  /// How a submap hangs on its parent, if it is under way.
  std::optional<Joint> joint(std::size_t submap) const;
  /// Number of the submap that scans are matched against, and its walls; null before the first scan.
  std::size_t submap() const { return now_.submap; }
  const SurfaceMap* walls() const { return older_ ? &older_->surface : nullptr; }

  const OdometryTrust& trust() const { return now_.trust; }

 private:
  struct Active : UnderWay {
    explicit Active(double resolution) : surface(resolution) {}
    Active(double resolution, const State::Active& state)
        : UnderWay(state), surface(resolution, state.surface) {}
    State::Active state() const { return {*this, surface.state()}; }
    Submap finished(std::size_t nodes) const;
    SurfaceMap surface;
  };
  Active begun(std::size_t node, const Joint& joint) const;
  struct Match {
    Refined refined;
    UncertainPose prior;
  };
  Match match(const Scan& scan, const UncertainPose& predicted);
  /// Tracked::held of a scan that was matched so.
  int held(const Scan& scan, const Pose2& X_OB, const Refined& match);

  SlamOptions options_;
  Motion now_;
  std::optional<Active> older_;
  std::optional<Active> younger_;
  Joint start_;  ///< of the next submap, if nothing is under way
  /// The newest scan that met the map or what was seen before, and where odometry was.
  struct Met {
    Pose2 X_OB;
    RangeImage ranges;
  };
  std::optional<Met> met_;
  int held_ = 0;
};

}  // namespace bw::slam
