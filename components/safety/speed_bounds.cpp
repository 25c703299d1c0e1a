// How fast a motion may be, by each thing that the laser saw: the stopping distance, narrow things, sight.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "components/model/footprint_outline.hpp"
#include "components/model/footprint_touch.hpp"
#include "components/model/stopping.hpp"
#include "components/safety/collision_monitor.hpp"

namespace bw::safety {
namespace {

constexpr double kShortestLever = 1e-3;
constexpr double kFreely = 0.9;  // share of the sector of travel that must be covered
constexpr double kSwings =
    0.01;  // [m]: what of an outline lies no farther out than its inner disc does not swing
constexpr double kSwingStep = 0.05;  // [m]

bool covers(const std::vector<Vector2>& corners, const Vector2& p) {
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (cross(corners[(i + 1) % corners.size()] - corners[i], p - corners[i]) < 0.0) return false;
  return true;
}

}  // namespace

/// What a stop on the arc of `along` costs: of a rotation in place [rad/s^2].
Stopping CollisionMonitor::stopping_on(const Twist2& along) const {
  const Twist2 braking = braking_of(along, stopping_.deceleration, wheel_separation_);
  return {stopping_.reaction_time, along.v != 0.0 ? braking.v : braking.omega, stopping_.approach_speed};
}

/// Speed along the arc of `along` that the stopping distance allows; of a rotation in place the turn rate.
/// From `enough` on any number that is as large will do.
double CollisionMonitor::rule_speed(const Twist2& along, const Ahead& ahead, double enough) const {
  Ahead near{{}, ahead.nearer, ahead.X_seen_now};
  const Stopping stopping = stopping_on(along);
  const double travel = enough * (stopping.reaction_time + 0.5 * enough / stopping.deceleration);
  const double kept = kept_free_.radius + options_.stopping.margin + ahead.nearer +
                      stopping.approach_speed * (stopping.reaction_time + enough / stopping.deceleration);
  for (const SeenPoint& point : ahead.points) {
    // The side that touches it comes from within the radius, and its lever is no longer than this.
    const double distance = point.position.norm();
    const double lever = along.v != 0.0 ? 1.0 + distance * std::abs(along.omega / along.v) : distance;
    if (distance < kept + lever * travel) near.points.push_back(point);
  }
  return kept_free_.is_polygon() ? polygon_speed(along, near) : disc_speed(along, near);
}

/// Each point on its own: the side that touches it travels its own distance, `lever` times that of base_link.
double CollisionMonitor::polygon_speed(const Twist2& along, const Ahead& ahead) const {
  const StoppingOptions& rule = options_.stopping;
  const Stopping on_arc = stopping_on(along);
  double speed = std::numeric_limits<double>::infinity();
  for (const SeenPoint& point : ahead.points) {
    const TouchOnArc touch = first_touch(along, kept_free_.polygon, point.position);
    if (std::isinf(touch.distance)) continue;
    const bool is_deep = std::isfinite(first_touch(along, core_.polygon, point.position).distance);
    const double lever = std::max(touch.lever, kShortestLever);
    const Stopping stopping{on_arc.reaction_time, on_arc.deceleration, stopping_.approach_speed / lever};
    const double distance = touch.distance - (rule.margin + ahead.nearer) / lever;
    const double end_speed =
        is_deep ? 0.0 : rule.graze_speed / (along.v != 0.0 ? std::max(1.0, lever) : lever);
    speed = std::min(speed, speed_within(distance, stopping, end_speed));
  }
  return speed;
}

double CollisionMonitor::disc_speed(const Twist2& along, const Ahead& ahead) const {
  const StoppingOptions& rule = options_.stopping;
  double distance = std::numeric_limits<double>::infinity();
  double deep_distance = distance;
  for (const SeenPoint& point : ahead.points) {
    const double touch = free_distance(along, kept_free_.radius, point.position);
    distance = std::min(distance, touch);
    if (std::isfinite(free_distance(along, kept_free_.radius - rule.kGraze, point.position)))
      deep_distance = std::min(deep_distance, touch);
  }
  const double kept = rule.margin + ahead.nearer;
  const Stopping stopping = stopping_on(along);
  return std::min(speed_within(deep_distance - kept, stopping),
                  speed_within(distance - kept, stopping, rule.graze_speed));
}

/// The same for narrow things and the bodies that may be above them.
double CollisionMonitor::narrow_speed(const Twist2& along, const Ahead& ahead) const {
  const StoppingOptions& rule = options_.stopping;
  double distance = std::numeric_limits<double>::infinity();
  for (const SeenPoint& point : ahead.points) {
    if (!point.is_narrow) continue;
    distance = std::min(distance, free_distance_to_walker(along, wide_, point.position));
  }
  return speed_within(distance - ahead.nearer, stopping_on(along), rule.kNarrowSpeed);
}

double CollisionMonitor::dark() const {
  return std::abs(seen_.angle_increment) *
         static_cast<double>(std::count(seen_.dark.begin(), seen_.dark.end(), true));
}

double CollisionMonitor::sight_speed(double v, const Ahead& ahead) const {
  const SightOptions& options = options_.sight;
  const double bearing = ahead.X_seen_now.theta + (v > 0.0 ? 0.0 : std::numbers::pi);
  const Sight sight = sight_of(seen_, bearing, options.kHalfAngle);
  if (sight.unknown - sight.dark > options.kStopUnknown) return 0.0;
  const bool is_seen =
      sight.covered >= kFreely && sight.unknown <= options.kMaxUnknown && sight.widest_gap <= options.kMaxGap;
  return is_seen ? std::numeric_limits<double>::infinity() : options.creep_speed;
}

/// Of a motion that is mostly a rotation: a polygon's sides swing through positions that must be seen, as far
/// as they get before they stand.
/// Else the outermost point of the outline moves at creep_speed.
double CollisionMonitor::swing_share(const Twist2& wanted, const Ahead& ahead) const {
  const double rim = kept_free_.radius * std::abs(wanted.omega);
  const double fastest = rim + std::abs(wanted.v);
  if (!kept_free_.is_polygon() || rim <= std::abs(wanted.v) || fastest <= options_.sight.creep_speed)
    return 1.0;
  const double braking = braking_of({0.0, wanted.omega}, stopping_.deceleration, wheel_separation_).omega;
  const double angle =
      std::abs(wanted.omega) * (stopping_.reaction_time + 0.5 * std::abs(wanted.omega) / braking) +
      options_.stopping.margin / kept_free_.radius;
  const double inner = inscribed_radius(kept_free_) + kSwings;
  const std::vector<Vector2>& corners = kept_free_.polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 side = corners[(i + 1) % corners.size()] - corners[i];
    const int parts = static_cast<int>(std::ceil(side.norm() / kSwingStep));
    for (int part = 0; part < parts; ++part) {
      const Vector2 rim_point = corners[i] + side * (static_cast<double>(part) / parts);
      if (rim_point.norm() <= inner) continue;
      for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const Vector2 swept = rotate({0.0, 0.0, std::copysign(share * angle, wanted.omega)}, rim_point);
        if (!covers(corners, swept) && !sees(seen_, ahead.X_seen_now * swept))
          return options_.sight.creep_speed / fastest;
      }
    }
  }
  return 1.0;
}

}  // namespace bw::safety
