#include "components/safety/collision_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/footprint_outline.hpp"
#include "components/model/stopping.hpp"
#include "components/model/transform2.hpp"
#include "components/safety/stop_path.hpp"

namespace bw::safety {
namespace {

constexpr double kRestSpeed = 0.02;  // [m/s]: slower is at rest, and no speed worth driving
constexpr double kRotating = 0.02;   // [rad/s]: the same of a rotation

std::string_view cause_of(LaserState state) {
  if (state == LaserState::silent) return kLaserSilent;
  if (state == LaserState::frozen) return kLaserFrozen;
  return state == LaserState::invalid ? kLaserInvalid : kLaserWaiting;
}

}  // namespace

CollisionMonitor::CollisionMonitor(const Robot& robot, const CollisionMonitorOptions& options)
    : limits_(robot.limits),
      wheel_separation_(robot.wheel_separation),
      own_(robot.outline()),
      footprint_(own_),
      empty_sight_(options.sweep),
      watch_(Duration::seconds(options.source_timeout)),
      hold_(Duration::seconds(options.kClearAfter), robot.limits.acc_max) {
  set_options(options);
}

void CollisionMonitor::set_options(const CollisionMonitorOptions& options) {
  options_ = options;
  set_footprint(footprint_);
  stopping_ = {options.stopping.reaction_time, limits_.stop_deceleration, options.stopping.approach_speed};
  zones_.clear();
  for (const ZoneOptions& zone : options_.polygons) {
    if (zone.enabled) zones_.emplace_back(zone);
  }
  held_cause_.cause = kStoppingDistance;  // it may have been the name of a zone
}

void CollisionMonitor::set_footprint(const Footprint& footprint) {
  footprint_ = hull(own_, footprint);
  kept_free_ = padded(footprint_, options_.stopping.padding);
  core_ = padded(kept_free_, -options_.stopping.kGraze);
  wide_ = padded(kept_free_, options_.stopping.narrow_margin);
}

void CollisionMonitor::follow_clock(Time now) {
  if (now < newest_) {
    watch_.forget(now);
    stamps_ = {};
    poses_ = {};
    if (odometry_at_) odometry_at_ = now - Duration::seconds(options_.source_timeout) - Duration{1};
    if (fault_at_) fault_at_ = now;
  }
  newest_ = now;
}

void CollisionMonitor::odometry(Time time, const Pose2& X_OB, const Twist2& twist) {
  follow_clock(time);
  if (!is_finite(X_OB) || !is_finite(twist)) return;
  odometry_at_ = time;
  twist_ = twist;
  poses_.add(time, X_OB, twist);
}

void CollisionMonitor::sweep(Time now, LaserSweep sweep, const StampSource& source) {
  follow_clock(now);
  stamp_ = stamps_.add(now, sweep.time, source, Duration::seconds(options_.source_timeout));
  if (poses_.is_empty()) return;  // nobody says where it was measured
  if (stamp_.fault != StampFault::none) return refuse(now, sweep, SweepFault::bad_stamp);
  const Time measured_at = now - stamp_.age;
  const Pose2 X_OB = poses_.at(measured_at);
  const auto pose_at_beam = [&](Time time) {
    return inverse(X_OB) * poses_.at(measured_at + (time - sweep.time));
  };
  const std::vector<Pose2> poses = beam_poses(sweep, sweep.X_FL, pose_at_beam);
  sweep.beam_poses = poses;
  CheckedSweep checked = check_sweep(sweep, options_.sweep);
  if (checked.fault == SweepFault::none && !empty_sight_.believes(sweep, X_OB, checked))
    checked.fault = SweepFault::no_returns;
  sweep_fault_ = checked.fault;
  if (!watch_.add(now, sweep.time, sweep.ranges, checked.fault, X_OB)) return;
  seen_ = std::move(checked);
  X_OB_seen_ = X_OB;
  seen_at_ = measured_at;
}

void CollisionMonitor::refuse(Time now, const LaserSweep& sweep, SweepFault why) {
  follow_clock(now);
  sweep_fault_ = why;
  watch_.add(now, sweep.time, sweep.ranges, why, poses_.at(now));
}

std::optional<std::string_view> CollisionMonitor::fault(Time now) {
  const LaserState state = watch_.state(now);
  const bool has_odometry = odometry_at_ && (now - *odometry_at_).to_seconds() <= options_.source_timeout;
  if (state != LaserState::ok || !has_odometry) {
    const bool is_start = state == LaserState::waiting || !odometry_at_;
    const bool is_laser = state != LaserState::ok && !poses_.is_empty();  // without odometry no sweep counts
    fault_cause_ = is_laser ? cause_of(state) : kOdometrySilent;
    fault_at_ = now;
    latched_ = latched_ || (options_.resume == Resume::manual && !is_start);
    return fault_cause_;
  }
  if (latched_) return kWaitingForReset;
  if (fault_at_ && (now - *fault_at_).to_seconds() < options_.kClearAfter) return fault_cause_;
  fault_at_.reset();
  return std::nullopt;
}

CollisionMonitor::Ahead CollisionMonitor::ahead_at(Time now) const {
  const Pose2 X_now_seen = inverse(poses_.at(now)) * X_OB_seen_;
  Ahead ahead{seen_.points, options_.stopping.approach_speed * (now - seen_at_).to_seconds(),
              inverse(X_now_seen)};
  const Transform2 to_now(X_now_seen);
  for (SeenPoint& point : ahead.points) point.position = to_now * point.position;
  return ahead;
}

/// Whether the robot, stopped a reaction time from now, closes in on nothing: neither on its present path,
/// nor on that of `told`, nor where it rotates as told already, but is not as fast yet: motor control bounds
/// the jerk of its speed, and not that of its rotation.
bool CollisionMonitor::stops_in_time(const Verdict& told, const Ahead& ahead) const {
  const StopPath path{limits_, wheel_separation_, stopping_.reaction_time};
  const auto is_gentle = [&](const Told& what) {
    return closing_speed(path, kept_free_, twist_, what, ahead.points) <= kGentle;
  };
  const bool speeds_up = std::abs(told.allowed.v) > std::abs(twist_.v);
  return is_gentle({twist_}) && is_gentle({told.allowed, told.action}) &&
         (!speeds_up || is_gentle({{twist_.v, told.allowed.omega}, told.action}));
}

CollisionMonitor::Bound CollisionMonitor::tightest(const Twist2& wanted, const Ahead& ahead) const {
  Bound bound{std::numeric_limits<double>::infinity(), Action::do_nothing, ""};
  const auto consider = [&](double speed, Action action, std::string_view cause) {
    if (speed < bound.speed) bound = {speed, action, cause};
  };
  const double enough = std::max(limits_.v_max, std::abs(wanted.v));
  consider(rule_speed(wanted, ahead, enough), Action::approach, kStoppingDistance);
  if (options_.stopping.narrow_margin > 0.0)
    consider(narrow_speed(wanted, ahead), Action::approach, kNarrowThing);
  consider(sight_speed(wanted.v, ahead), Action::limit, kSight);
  if (const double share = swing_share(wanted, ahead); share < 1.0)
    consider(share * std::abs(wanted.v), Action::limit, kSight);
  for (const Zone& zone : zones_) {
    const double share = zone.share_left(wanted, ahead.points);
    if (share < 1.0) consider(share * std::abs(wanted.v), zone.options().action_type, zone.options().name);
  }
  return bound;
}

/// Of a rotation in place, what the stopping distance leaves.
double CollisionMonitor::rotation_share(double omega, const Ahead& ahead) const {
  if (!kept_free_.is_polygon() || omega == 0.0) return 1.0;
  return std::min(1.0, rule_speed({0.0, omega}, ahead, std::abs(omega)) / std::abs(omega));
}

/// `wanted` at `speed` on the same path; at rest it may rotate in place.
Twist2 CollisionMonitor::shrink(const Twist2& wanted, double speed, const Ahead& ahead) const {
  if (speed < kRestSpeed) speed = 0.0;
  if (speed == 0.0 && std::abs(twist_.v) < kRestSpeed && wanted.omega != 0.0)
    return judge_rotation({0.0, wanted.omega}, ahead).allowed;
  const double share = speed / std::abs(wanted.v);
  return {wanted.v * share, wanted.omega * share};
}

/// Of a rotation in place.
Verdict CollisionMonitor::judge_rotation(const Twist2& wanted, const Ahead& ahead) const {
  Verdict verdict{wanted, Action::do_nothing, ""};
  const auto consider = [&](double share, Action action, std::string_view cause) {
    if (std::abs(share * wanted.omega) < std::abs(verdict.allowed.omega))
      verdict = {{0.0, share * wanted.omega}, action, cause};
  };
  for (const Zone& zone : zones_)
    consider(zone.share_left(wanted, ahead.points), zone.options().action_type, zone.options().name);
  consider(rotation_share(wanted.omega, ahead), Action::approach, kStoppingDistance);
  consider(swing_share(wanted, ahead), Action::limit, kSight);
  // What it does now must fit as well.
  if (std::abs(twist_.omega) > std::abs(verdict.allowed.omega) + kRotating &&
      rotation_share(twist_.omega, ahead) < 1.0)
    return {verdict.allowed, Action::approach, kStoppingDistance};
  return verdict;
}

Verdict CollisionMonitor::judge(Time now, const Twist2& wanted) {
  follow_clock(now);
  if (const auto cause = fault(now)) return {{}, Action::stop, *cause};
  if (!is_finite(wanted)) return {{}, Action::stop, "command_not_finite"};
  const Ahead ahead = ahead_at(now);
  const Verdict verdict = judge_command(now, wanted, ahead);
  return stops_in_time(verdict, ahead) ? verdict : Verdict{{}, Action::stop, kStoppingDistance};
}

Verdict CollisionMonitor::judge_command(Time now, const Twist2& wanted, const Ahead& ahead) {
  Verdict verdict{wanted, Action::do_nothing, ""};
  if (wanted.v != 0.0) {
    const Bound bound = tightest(wanted, ahead);
    const double speed = hold_.update(now, std::min(bound.speed, std::max(limits_.v_max, std::abs(wanted.v))),
                                      wanted.v > 0.0 ? 1 : -1);
    if (bound.speed <= speed) held_cause_ = bound;
    if (speed < std::abs(wanted.v)) {
      verdict.allowed = shrink(wanted, speed, ahead);
      verdict.action = speed < kRestSpeed ? Action::stop : held_cause_.action;
      verdict.cause = held_cause_.cause;
      return verdict;
    }
  } else {
    verdict = judge_rotation(wanted, ahead);
  }
  // The command asks for less than the robot still does: what it does now must fit as well, or it brakes
  // hard.
  if (std::abs(twist_.v) > std::abs(wanted.v) + kRestSpeed) {
    const double speed = rule_speed(twist_, ahead, std::abs(twist_.v));
    if (std::abs(twist_.v) > speed + kRestSpeed)
      return {verdict.allowed, Action::approach, kStoppingDistance};
  }
  return verdict;
}

}  // namespace bw::safety
