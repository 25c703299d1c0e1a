// How far a pose of SLAM can be trusted, and why not further: states and words as the localization has them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "components/model/health_state.hpp"
#include "components/slam/scan_tracking.hpp"
#include "runtime/base/time.hpp"

namespace bw::slam {

enum class HealthCause : std::uint8_t {
  none,
  no_scan,        ///< INIT
  kidnapped,      ///< LOST: the robot is not where it was
  odometry_jump,  ///< by so much between two scans [m]
  no_features,    ///< the scan shows hardly a wall
  no_match,       ///< the scan does not meet the map
  slip,           ///< way of the last second by odometry, and by scans [m]
  turn_slip,      ///< turn of the last second by odometry, and by scans [rad]
  unseen          ///< walls show nothing of where the robot is along this direction of the map, 0 to pi [rad]
};

struct SlamHealth {
  HealthState state = HealthState::init;
  HealthCause cause = HealthCause::no_scan;
  double value = 0.0;  ///< in the unit that the cause names
  double by_scans = 0.0;
};

/// [s] what is over is told so long: a jump, having been carried
inline constexpr double kToldFor = 5.0;

/// Looks at each scan as it was tracked.
class HealthWatch {
 public:
  /// `points`: of the scan; X_MB: as it was told.
  void add(const Tracked& tracked, std::size_t points, const Pose2& X_MB, Time time);
  SlamHealth health(Time now) const;

  /// The robot was put elsewhere: scans do not meet the map all at once, though it hardly moved by odometry.
  bool is_kidnapped() const { return kidnapped_; }

 private:
  struct Step {
    Time time;
    Eigen::Vector3d wheels;   ///< (x, y, theta) by odometry
    Eigen::Vector3d scanned;  ///< with what the scan says
  };
  std::optional<SlamHealth> slip() const;

  bool began_ = false;
  bool kidnapped_ = false;
  double inliers_ = 1.0;
  std::size_t points_ = 0;
  std::optional<double> unseen_;  ///< direction in the map that the scan does not show [rad]
  Time unseen_since_;
  std::deque<Step> steps_;  ///< of the last second
  std::optional<Time> jumped_;
  double jump_ = 0.0;  ///< [m] by odometry from one scan to the next
};

}  // namespace bw::slam
