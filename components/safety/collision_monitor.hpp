// The last look before the wheels: passes a wanted velocity on only as far as the laser shows room for it.
// Knows no map, no plan, no people and no place, so that none of them can be wrong.
//
//   speed   the stop, reaction included, plus `margin` must end inside the free distance of the robot's
//           footprint along the wanted arc (free_distance.hpp, footprint_touch.hpp); v and omega shrink
//           together, so the path stays
//   stop    what it does now and what it is told to do, a reaction later stopped, closes in on nothing (stop_path.hpp)
//   graze   what the side of the robot would touch by less than `graze` is passed at graze_speed
//   body    around narrow things (legs) the robot is down to narrow_speed narrow_margin earlier
//   sight   into a sector the laser does not see it creeps; into one whose beams are broken it stops; the sides of a polygon
//           swing no faster than that through what it does not see
//   zones   of nav2_collision_monitor (zone.hpp)
//   laser   silent, frozen, unsound or too old for source_timeout: a stop
//
// Rotating in place is always free for a disc; a polygon's sides come round, and are judged as on any arc.
// A motion that leads away from what is too near is free.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "components/model/footprint.hpp"
#include "components/model/robot.hpp"
#include "components/safety/action.hpp"
#include "components/safety/collision_monitor_options.hpp"
#include "components/safety/empty_sight.hpp"
#include "components/safety/free_distance.hpp"
#include "components/safety/limit_hold.hpp"
#include "components/safety/pose_history.hpp"
#include "components/safety/sweep.hpp"
#include "components/safety/sweep_watch.hpp"
#include "components/safety/zone.hpp"
#include "runtime/base/stamp_age.hpp"
#include "runtime/base/time.hpp"

namespace bw::safety {

struct Verdict {
  Twist2 allowed;                      ///< never faster than wanted
  Action action = Action::do_nothing;  ///< anything else: lower speeds are meant at stop_deceleration
  std::string_view cause;              ///< a zone's name, or one of the causes below
};

inline constexpr std::string_view kStoppingDistance = "stopping_distance";
inline constexpr std::string_view kNarrowThing = "narrow_thing";
inline constexpr std::string_view kSight = "sight";
inline constexpr std::string_view kLaserWaiting = "laser_waiting";
inline constexpr std::string_view kLaserSilent = "laser_silent";
inline constexpr std::string_view kLaserFrozen = "laser_frozen";
inline constexpr std::string_view kLaserInvalid = "laser_invalid";
inline constexpr bool is_laser_fault(std::string_view cause) {
  return cause == kLaserSilent || cause == kLaserFrozen || cause == kLaserInvalid;
}
inline constexpr std::string_view kOdometrySilent = "odometry_silent";
inline constexpr std::string_view kWaitingForReset = "waiting_for_reset";

/// Times are of the component clock. After one that went back nothing of before counts: neither sweep nor
/// odometry is fresh.
class CollisionMonitor {
 public:
  CollisionMonitor(const Robot& robot, const CollisionMonitorOptions& options);

  /// New zones, stopping distances and sight; what watches the laser stays as it was constructed. Causes of
  /// verdicts given before are no longer valid.
  void set_options(const CollisionMonitorOptions& options);
  /// What the robot carries, too, from now on: the outline is the convex hull around this and the robot
  /// file's own, so that no message makes it smaller than that.
  void set_footprint(const Footprint& footprint);
  /// It, and its padding.
  const Footprint& kept_free() const { return kept_free_; }

  /// Where the encoders say the robot is, and its true body velocity, at `time`.
  void odometry(Time time, const Pose2& X_OB, const Twist2& twist);
  /// A sweep that arrived at `now`, the laser in base_link; where that was at each beam is found by the
  /// odometry here. `source` says how old it is; one that is older than source_timeout, or of which nobody
  /// knows how old it is, is refused.
  void sweep(Time now, LaserSweep sweep, const StampSource& source = {});
  /// One that came and is of no use.
  void refuse(Time now, const LaserSweep& sweep, SweepFault why);
  /// Ends a stop after a fault of the laser, when resume is manual.
  void reset() {
    latched_ = false;
    empty_sight_.forget();
  }

  Verdict judge(Time now, const Twist2& wanted);
  /// Notices faults while nobody wants anything; that neither laser nor odometry has begun is none.
  void look(Time now) {
    follow_clock(now);
    if (odometry_at_ && watch_.state(now) != LaserState::waiting) fault(now);
  }

  LaserState laser(Time now) const { return watch_.state(now); }
  SweepFault sweep_fault() const { return sweep_fault_; }
  /// Of the newest sweep that was not refused for another reason.
  const StampAge& stamp() const { return stamp_; }
  /// Whether the laser ever hit anything.
  bool has_seen() const { return empty_sight_.has_seen(); }
  /// Of the last sound sweep, what lies dark [rad].
  double dark() const;
  const Twist2& actual() const { return twist_; }

 private:
  struct Bound {
    double speed = 0.0;  ///< [m/s]
    Action action = Action::do_nothing;
    std::string_view cause;
  };

  /// What the newest sweep shows, where it is now unless it moves.
  struct Ahead {
    std::vector<SeenPoint> points;  ///< in base_link
    double nearer = 0.0;            ///< [m] that what approaches has come since the sweep
    Pose2 X_seen_now;               ///< base_link now, in that of the sweep
  };

  void follow_clock(Time now);
  std::optional<std::string_view> fault(Time now);
  Ahead ahead_at(Time now) const;
  Stopping stopping_on(const Twist2& along) const;
  double rule_speed(const Twist2& along, const Ahead& ahead, double enough) const;
  double disc_speed(const Twist2& along, const Ahead& ahead) const;
  double polygon_speed(const Twist2& along, const Ahead& ahead) const;
  double narrow_speed(const Twist2& along, const Ahead& ahead) const;
  Bound tightest(const Twist2& wanted, const Ahead& ahead) const;
  double sight_speed(double v, const Ahead& ahead) const;
  double swing_share(const Twist2& wanted, const Ahead& ahead) const;
  bool stops_in_time(const Verdict& told, const Ahead& ahead) const;
  Verdict judge_command(Time now, const Twist2& wanted, const Ahead& ahead);
  Twist2 shrink(const Twist2& wanted, double speed, const Ahead& ahead) const;
  double rotation_share(double omega, const Ahead& ahead) const;
  Verdict judge_rotation(const Twist2& wanted, const Ahead& ahead) const;

  Time newest_;  ///< of all that came, on a clock that has not gone back since
  Limits limits_;
  double wheel_separation_;  ///< [m]
  Footprint own_;            ///< of the robot file
  Footprint footprint_;      ///< grown by what was told
  Footprint kept_free_;      ///< with padding
  Footprint core_;           ///< what is touched deeper than by a graze
  Footprint wide_;           ///< kept free of narrow things
  CollisionMonitorOptions options_;
  Stopping stopping_;
  std::vector<Zone> zones_;
  EmptySight empty_sight_;
  SweepWatch watch_;
  LimitHold hold_;
  Bound held_cause_;

  std::optional<Time> odometry_at_;
  Twist2 twist_;
  PoseHistory poses_;
  StampAges stamps_;
  StampAge stamp_;
  CheckedSweep seen_;
  SweepFault sweep_fault_ = SweepFault::none;
  Pose2 X_OB_seen_;  ///< where the robot was when the sweep in use was measured
  Time seen_at_;     ///< when that was
  std::optional<Time> fault_at_;
  std::string_view fault_cause_;
  bool latched_ = false;
};

}  // namespace bw::safety
