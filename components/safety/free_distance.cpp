#include "components/safety/free_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "components/model/footprint_touch.hpp"

namespace bw::safety {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kStraight =
    1e-5;  // [1/m]: flatter arcs leave the straight line by less than 1e-5 m in 1.4 m

double straight_distance(double radius, const Vector2& p) {
  const double reach = radius * radius - p.y() * p.y();
  if (p.x() <= 0.0 || reach <= 0.0) return kNever;
  return p.x() - std::sqrt(reach);
}

/// Angle at the centre of the arc from the start to the point, in the direction of travel, [0, 2 pi).
double angle_ahead(double rho, const Vector2& p) {
  const double phi = std::atan2(p.x(), std::abs(rho) - std::copysign(p.y(), p.y() * rho));
  return phi < 0.0 ? phi + 2.0 * std::numbers::pi : phi;
}

double arc_distance(double rho, double radius, const Vector2& p) {
  const double arc_radius = std::abs(rho);
  const double q = std::hypot(p.x(), p.y() - rho);
  if (std::abs(q - arc_radius) >= radius || q == 0.0) return kNever;
  const double cosine = (rho * rho + q * q - radius * radius) / (2.0 * arc_radius * q);
  if (cosine <= -1.0) return kNever;  // the point stays inside all the way round
  return arc_radius * (angle_ahead(rho, p) - std::acos(std::min(1.0, cosine)));
}

/// `distance` to the touch, `front` of the body ahead of its centre.
double distance_to_walker(const Twist2& twist, double distance, double front, const Vector2& point) {
  if (std::isinf(distance) || distance == 0.0) return distance;
  const Vector2 ahead(twist.v > 0.0 ? point.x() : -point.x(), point.y());
  const double curvature = twist.omega / twist.v;
  const double abreast =
      std::abs(curvature) < kStraight ? ahead.x() : angle_ahead(1.0 / curvature, ahead) / std::abs(curvature);
  return std::clamp(abreast - front, 0.0, distance);
}

}  // namespace

double free_distance(const Twist2& twist, double radius, const Vector2& point) {
  if (twist.v == 0.0) return kNever;
  // Backwards is forwards seen in a mirror across y: the centre of the arc stays where it is.
  const Vector2 ahead(twist.v > 0.0 ? point.x() : -point.x(), point.y());
  if (ahead.squaredNorm() < radius * radius) return ahead.x() > 0.0 ? 0.0 : kNever;
  const double curvature = twist.omega / twist.v;
  const double distance = std::abs(curvature) < kStraight ? straight_distance(radius, ahead)
                                                          : arc_distance(1.0 / curvature, radius, ahead);
  return std::max(0.0, distance);
}

double free_distance_to_walker(const Twist2& twist, double radius, const Vector2& point) {
  return distance_to_walker(twist, free_distance(twist, radius, point), radius, point);
}

double free_distance_to_walker(const Twist2& twist, const Footprint& footprint, const Vector2& point) {
  if (!footprint.is_polygon()) return free_distance_to_walker(twist, footprint.radius, point);
  double front = 0.0;
  for (const Vector2& corner : footprint.polygon)
    front = std::max(front, twist.v > 0.0 ? corner.x() : -corner.x());
  return distance_to_walker(twist, first_touch(twist, footprint.polygon, point).distance, front, point);
}

double speed_within(double distance, const Stopping& stopping, double end_speed) {
  const double a = stopping.deceleration;
  const double b = a * stopping.reaction_time + stopping.approach_speed;
  const double under_root =
      b * b + end_speed * end_speed + 2.0 * a * (distance - stopping.approach_speed * stopping.reaction_time);
  if (!(under_root > 0.0)) return end_speed;
  return std::max(end_speed, std::sqrt(under_root) - b);
}

}  // namespace bw::safety
