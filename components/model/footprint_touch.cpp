#include "components/model/footprint_touch.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bw {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kStraight =
    1e-5;  // [1/m]: flatter arcs leave the straight line by less than 1e-5 m in 1.4 m

/// Of a point inside, the side that is nearest to being passed outwards.
struct Depth {
  double inside = kNever;  ///< [m]; 0: the point is outside
  Vector2 outward{0.0, 0.0};
};

Depth depth_of(const std::vector<Vector2>& polygon, const Vector2& p) {
  Depth least;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double area = cross(side, p - polygon[i]);
    if (area <= 0.0) return {0.0, {0.0, 0.0}};
    const double length = side.norm();
    if (area / length < least.inside) least = {area / length, Vector2(side.y(), -side.x()) / length};
  }
  return least;
}

/// Distance of a point that runs along unit vector `u` from p until it is in the polygon.
double straight_distance(const std::vector<Vector2>& polygon, const Vector2& p, const Vector2& u) {
  double enter = 0.0;
  double leave = kNever;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double depth = cross(side, p - polygon[i]);  // grows with cross(side, u)
    const double rate = cross(side, u);
    if (rate == 0.0) {
      if (depth < 0.0) return kNever;
    } else if (rate > 0.0) {
      enter = std::max(enter, -depth / rate);
    } else {
      leave = std::min(leave, -depth / rate);
    }
  }
  return enter < leave ? enter : kNever;
}

/// Angle that a point rotates around `center`, in the sense of `sense` (1: counter-clockwise), until it
/// crosses a side.
double rotation_angle(const std::vector<Vector2>& polygon, const Vector2& center, const Vector2& p,
                      double sense) {
  const Vector2 from = p - center;
  const double squared = from.squaredNorm();
  double first = kNever;
  const auto consider = [&](const Vector2& at) {
    double angle = sense * std::atan2(cross(from, at), from.dot(at));
    if (angle < 0.0) angle += kTwoPi;
    first = std::min(first, angle);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 a = polygon[i] - center;
    const Vector2 side = polygon[(i + 1) % polygon.size()] - polygon[i];
    const double length = side.squaredNorm();
    const double middle = -a.dot(side) / length;
    const double under_root = (squared - a.squaredNorm()) / length + middle * middle;
    if (under_root < 0.0) continue;
    for (const double share : {middle - std::sqrt(under_root), middle + std::sqrt(under_root)})
      if (share >= 0.0 && share <= 1.0) consider(a + share * side);
  }
  return first;
}

}  // namespace

TouchOnArc first_touch(const Twist2& twist, const std::vector<Vector2>& polygon, const Vector2& point) {
  if (twist == Twist2{}) return {kNever, 1.0};
  const Depth depth = depth_of(polygon, point);
  if (depth.inside > 0.0) {
    // Velocity of the point, seen from the robot.
    const Vector2 moves(-twist.v + twist.omega * point.y(), -twist.omega * point.x());
    return {depth.outward.dot(moves) < 0.0 ? 0.0 : kNever, 1.0};
  }
  if (std::abs(twist.omega) < kStraight * std::abs(twist.v))
    return {straight_distance(polygon, point, {twist.v > 0.0 ? -1.0 : 1.0, 0.0}), 1.0};
  const Vector2 center(0.0, twist.v / twist.omega);
  const double angle = rotation_angle(polygon, center, point, twist.omega > 0.0 ? -1.0 : 1.0);
  const double radius = (point - center).norm();
  if (twist.v == 0.0) return {angle, radius};
  return {angle * std::abs(center.y()), radius / std::abs(center.y())};
}

}  // namespace bw
