#include "components/safety/collision_monitor.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "components/model/differential_drive.hpp"
#include "components/model/sweep_motion.hpp"

namespace bw::safety {
namespace {

constexpr double kStanding = 0.02;        // [m/s]: slower is at rest, and no speed worth driving
constexpr double kFreely = 0.9;           // share of the sector of travel that must be covered
constexpr double kLongestSweepAge = 0.2;  // [s]: a stamp that is older is of another clock

std::string_view cause_of(LaserState state) {
  if (state == LaserState::silent) return kLaserSilent;
  if (state == LaserState::frozen) return kLaserFrozen;
  return state == LaserState::invalid ? kLaserInvalid : kLaserWaiting;
}

}  // namespace

CollisionMonitor::CollisionMonitor(const Robot& robot, const CollisionMonitorOptions& options)
    : limits_(robot.limits),
      robot_radius_(robot.radius),
      empty_sight_(options.sweep),
      watch_(Duration::seconds(options.source_timeout)),
      hold_(Duration::seconds(options.clear_after), robot.limits.acc_max) {
  set_options(options);
}

void CollisionMonitor::set_options(const CollisionMonitorOptions& options) {
  options_ = options;
  radius_ = robot_radius_ + options.stopping.padding;
  stopping_ = {options.stopping.reaction_time, limits_.stop_deceleration, options.stopping.approach_speed};
  zones_.clear();
  for (const ZoneOptions& zone : options_.polygons) {
    if (zone.enabled) zones_.emplace_back(zone);
  }
  held_cause_.cause = kStoppingDistance;  // it may have been the name of a zone
}

void CollisionMonitor::odometry(Time time, const Pose2& X_OB, const Twist2& twist) {
  if (!is_finite(X_OB) || !is_finite(twist)) return;
  odometry_at_ = time;
  X_OB_ = X_OB;
  twist_ = twist;
}

Pose2 CollisionMonitor::pose_at(Time time) const {
  if (!odometry_at_) return X_OB_;
  return advance_exact(X_OB_, twist_, std::clamp((time - *odometry_at_).to_seconds(), -0.3, 0.3));
}

void CollisionMonitor::sweep(Time now, LaserSweep sweep) {
  const double age = (now - sweep.time).to_seconds();
  const Time measured_at = age >= 0.0 && age <= kLongestSweepAge ? sweep.time : now;
  const Pose2 X_OB = pose_at(measured_at);
  const auto pose_at_beam = [&](Time time) {
    return inverse(X_OB) * pose_at(measured_at + (time - sweep.time));
  };
  const std::vector<Pose2> poses = beam_poses(sweep, sweep.X_FL, pose_at_beam);
  sweep.beam_poses = poses;
  CheckedSweep checked = check_sweep(sweep, options_.sweep);
  if (checked.fault == SweepFault::none && !empty_sight_.believes(sweep, checked))
    checked.fault = SweepFault::no_returns;
  sweep_fault_ = checked.fault;
  if (!watch_.add(now, sweep.time, sweep.ranges, checked.fault, X_OB)) return;
  seen_ = std::move(checked);
  X_OB_seen_ = X_OB;
  seen_at_ = measured_at;
}

void CollisionMonitor::refuse_unplaced(Time now, const LaserSweep& sweep) {
  sweep_fault_ = SweepFault::unplaced;
  watch_.add(now, sweep.time, sweep.ranges, sweep_fault_, X_OB_);
}

std::optional<std::string_view> CollisionMonitor::fault(Time now) {
  const LaserState state = watch_.state(now);
  const bool has_odometry =
      odometry_at_ && std::abs((now - *odometry_at_).to_seconds()) <= options_.source_timeout;
  if (fault_at_ && *fault_at_ > now) fault_at_ = now;  // the clock went back
  if (state != LaserState::ok || !has_odometry) {
    const bool is_start = state == LaserState::waiting || !odometry_at_;
    fault_cause_ = state != LaserState::ok ? cause_of(state) : kOdometrySilent;
    fault_at_ = now;
    latched_ = options_.resume == Resume::manual && !is_start;
    return fault_cause_;
  }
  if (latched_) return kWaitingForReset;
  if (fault_at_ && (now - *fault_at_).to_seconds() < options_.clear_after) return fault_cause_;
  fault_at_.reset();
  return std::nullopt;
}

CollisionMonitor::Ahead CollisionMonitor::ahead_at(Time now) const {
  const Pose2 X_now_seen = inverse(pose_at(now)) * X_OB_seen_;
  Ahead ahead{seen_.points, options_.stopping.approach_speed * (now - seen_at_).to_seconds()};
  for (SeenPoint& point : ahead.points) point.position = X_now_seen * point.position;
  return ahead;
}

/// Speed along the arc of `along` that the stopping distance allows.
double CollisionMonitor::rule_speed(const Twist2& along, const Ahead& ahead) const {
  const StoppingOptions& rule = options_.stopping;
  double way = std::numeric_limits<double>::infinity();
  double deep_way = way;
  for (const SeenPoint& point : ahead.points) {
    const double touch = free_way(along, radius_, point.position);
    way = std::min(way, touch);
    if (std::isfinite(free_way(along, radius_ - rule.graze, point.position)))
      deep_way = std::min(deep_way, touch);
  }
  const double kept = rule.margin + ahead.nearer;
  return std::min(speed_within(deep_way - kept, stopping_),
                  speed_within(way - kept, stopping_, rule.graze_speed));
}

/// The same for narrow things and the bodies that may be above them.
double CollisionMonitor::narrow_speed(const Twist2& along, const Ahead& ahead) const {
  const StoppingOptions& rule = options_.stopping;
  double way = std::numeric_limits<double>::infinity();
  for (const SeenPoint& point : ahead.points) {
    if (!point.is_narrow) continue;
    way = std::min(way, free_way_to_walker(along, radius_ + rule.narrow_margin, point.position));
  }
  return speed_within(way - ahead.nearer, stopping_, rule.narrow_speed);
}

double CollisionMonitor::sight_speed(double v) const {
  const SightOptions& options = options_.sight;
  const Sight sight = sight_of(seen_, v > 0.0 ? 0.0 : std::numbers::pi, options.half_angle);
  if (sight.unknown > options.stop_unknown) return 0.0;
  const bool is_seen =
      sight.covered >= kFreely && sight.unknown <= options.max_unknown && sight.widest_gap <= options.max_gap;
  return is_seen ? std::numeric_limits<double>::infinity() : options.creep_speed;
}

CollisionMonitor::Bound CollisionMonitor::tightest(const Twist2& wanted, const Ahead& ahead) const {
  Bound bound{std::numeric_limits<double>::infinity(), Action::do_nothing, ""};
  const auto consider = [&](double speed, Action action, std::string_view cause) {
    if (speed < bound.speed) bound = {speed, action, cause};
  };
  consider(rule_speed(wanted, ahead), Action::approach, kStoppingDistance);
  if (options_.stopping.narrow_margin > 0.0)
    consider(narrow_speed(wanted, ahead), Action::approach, kNarrowThing);
  consider(sight_speed(wanted.v), Action::limit, kSight);
  for (const Zone& zone : zones_) {
    const double share = zone.share_left(wanted, ahead.points);
    if (share < 1.0) consider(share * std::abs(wanted.v), zone.options().action_type, zone.options().name);
  }
  return bound;
}

/// `wanted` at `speed` on the same path. While the robot brakes its turn rate follows its speed; at rest it
/// may turn on the spot.
Twist2 CollisionMonitor::shrink(const Twist2& wanted, double speed) const {
  if (speed < kStanding) speed = 0.0;
  const bool at_rest = speed == 0.0 && std::abs(twist_.v) < kStanding;
  const double share = speed / std::abs(wanted.v);
  const double turn_share = at_rest ? 1.0 : std::max(share, std::abs(twist_.v) / std::abs(wanted.v));
  return {wanted.v * share, wanted.omega * std::min(1.0, turn_share)};
}

Verdict CollisionMonitor::judge(Time now, const Twist2& wanted) {
  if (const auto cause = fault(now)) return {{}, Action::stop, *cause};
  if (!is_finite(wanted)) return {{}, Action::stop, "command_not_finite"};
  const Ahead ahead = ahead_at(now);
  Verdict verdict{wanted, Action::do_nothing, ""};
  if (wanted.v != 0.0) {
    const Bound bound = tightest(wanted, ahead);
    const double speed = hold_.update(now, std::min(bound.speed, std::max(limits_.v_max, std::abs(wanted.v))),
                                      wanted.v > 0.0 ? 1 : -1);
    if (bound.speed <= speed) held_cause_ = bound;
    if (speed < std::abs(wanted.v)) {
      verdict.allowed = shrink(wanted, speed);
      verdict.action = speed < kStanding ? Action::stop : held_cause_.action;
      verdict.cause = held_cause_.cause;
      return verdict;
    }
  } else {
    for (const Zone& zone : zones_) {
      const double share = zone.share_left(wanted, ahead.points);
      if (std::abs(share * wanted.omega) >= std::abs(verdict.allowed.omega)) continue;
      verdict = {{0.0, share * wanted.omega}, zone.options().action_type, zone.options().name};
    }
  }
  // The command asks for less than the robot still does: what it does now must fit as well, or it brakes
  // hard.
  if (std::abs(twist_.v) > std::abs(wanted.v) + kStanding) {
    const double speed = rule_speed(twist_, ahead);
    if (std::abs(twist_.v) > speed + kStanding) return {verdict.allowed, Action::approach, kStoppingDistance};
  }
  return verdict;
}

}  // namespace bw::safety
