#include "components/local_planner/orca/half_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "components/model/nearest_point.hpp"

namespace bw::orca {
namespace {

constexpr double kTie = 1e-9;  // [m/s] by which a leg must be nearer than the right one

// The line at `point` whose allowed side is the one `outward` points to.
HalfPlane beyond(const Vector2& point, const Vector2& outward) {
  return {point, {outward.y(), -outward.x()}};
}

// A direction even where there is none.
Vector2 unit_or(const Vector2& v, const Vector2& otherwise) {
  const double norm = v.norm();
  return norm > 0.0 ? Vector2(v / norm) : otherwise;
}

struct Legs {
  Vector2 right;
  Vector2 left;
};

// Tangents from the origin to the disc at `p`, |p| > radius.
Legs tangents(const Vector2& p, double radius) {
  const double distance2 = p.squaredNorm();
  const double length = std::sqrt(std::max(0.0, distance2 - radius * radius));
  return {Vector2(p.x() * length + p.y() * radius, p.y() * length - p.x() * radius) / distance2,
          Vector2(p.x() * length - p.y() * radius, p.y() * length + p.x() * radius) / distance2};
}

}  // namespace

HalfPlane clear_of(const MovingDisc& other, const Vector2& own, double share, double horizon,
                   double time_step) {
  const Vector2& p = other.offset;
  const double radius = other.radius;
  const Vector2 relative = own - other.velocity;
  const bool overlaps = p.squaredNorm() <= radius * radius;
  const double time = overlaps ? time_step : horizon;
  const Vector2 from_centre = relative - p / time;  // of the disc that cuts the cone off
  const double ahead = from_centre.dot(p);
  if (overlaps || (ahead < 0.0 && ahead * ahead > radius * radius * from_centre.squaredNorm())) {
    const double distance = from_centre.norm();
    const Vector2 outward = unit_or(from_centre, unit_or(-p, {-1.0, 0.0}));
    return beyond(own + share * (radius / time - distance) * outward, outward);
  }
  const Legs legs = tangents(p, radius);
  const Vector2 direction = cross(p, from_centre) > 0.0 ? legs.left : Vector2(-legs.right);
  return {own + share * (relative.dot(direction) * direction - relative), direction};
}

HalfPlane clear_of(const Segment& wall, double radius, const Vector2& own, double horizon) {
  const Vector2 nearest = nearest_point(wall, Vector2(0.0, 0.0));
  if (nearest.squaredNorm() <= radius * radius)
    return beyond({0.0, 0.0}, unit_or(-nearest, unit_or(-own, {-1.0, 0.0})));
  // The velocities that touch it are a convex set, all of one side of each of its tangents. Of these the one
  // that `own` is furthest outside of, or least inside: the tangent at the nearest point of the border.
  const Legs at_a = tangents(wall.a, radius);
  const Legs at_b = tangents(wall.b, radius);
  const Vector2 right = cross(at_a.right, at_b.right) < 0.0 ? at_b.right : at_a.right;
  const Vector2 left = cross(at_a.left, at_b.left) > 0.0 ? at_b.left : at_a.left;
  const auto clearance = [&](const Vector2& outward) {
    return std::min(outward.dot(own - wall.a / horizon), outward.dot(own - wall.b / horizon)) -
           radius / horizon;
  };
  Vector2 best{right.y(), -right.x()};
  double largest = clearance(best);
  const Vector2 along = unit_or(wall.b - wall.a, {0.0, 0.0});
  const Vector2 across{-along.y(), along.x()};
  const std::array<Vector2, 5> others = {Vector2(-left.y(), left.x()),
                                         unit_or(own - wall.a / horizon, {0.0, 0.0}),
                                         unit_or(own - wall.b / horizon, {0.0, 0.0}), across, -across};
  for (const Vector2& outward : others) {
    // From the right leg's normal over the front to the left one's: none of them looks along a leg.
    if (outward.isZero() || outward.dot(right) > kTie || outward.dot(left) > kTie) continue;
    if (clearance(outward) <= largest + kTie) continue;
    largest = clearance(outward);
    best = outward;
  }
  return beyond(own - largest * best, best);
}

}  // namespace bw::orca
