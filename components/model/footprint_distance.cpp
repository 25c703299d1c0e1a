#include "components/model/footprint_distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bw {
namespace {

Vector2 left_of(const Vector2& v) { return {-v.y(), v.x()}; }

// From the nearest point of segment a-b to `point`.
Vector2 away_from(const Vector2& a, const Vector2& b, const Vector2& point) {
  const Vector2 edge = b - a;
  const double length = edge.squaredNorm();
  const double share = length == 0.0 ? 0.0 : std::clamp((point - a).dot(edge) / length, 0.0, 1.0);
  return point - a - share * edge;
}

bool cross_each_other(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d) {
  const double side_a = cross(d - c, a - c);
  const double side_b = cross(d - c, b - c);
  const double side_c = cross(b - a, c - a);
  const double side_d = cross(b - a, d - a);
  return side_a * side_b < 0.0 && side_c * side_d < 0.0;
}

// In base_link: the distance, the unit vector from footprint to obstacle, and the point of either that it
// acts at.
struct Contact {
  double distance = std::numeric_limits<double>::infinity();
  Vector2 normal{0.0, 0.0};
  Vector2 point{0.0, 0.0};
};

using Corners = std::vector<Vector2>;

const Vector2& after(const Corners& corners, std::size_t i) {
  return corners[i + 1 == corners.size() ? 0 : i + 1];
}

// Crossing number: whatever way round the corners run.
bool holds(const Corners& corners, const Vector2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2& p = corners[i];
    const Vector2& q = after(corners, i);
    if ((p.y() > point.y()) != (q.y() > point.y()) &&
        point.x() < (q.x() - p.x()) * (point.y() - p.y()) / (q.y() - p.y()) + p.x()) {
      inside = !inside;
    }
  }
  return inside;
}

// The nearest pair of points, one of them on the outline; `sign` -1 for an obstacle inside of it.
Contact nearest_pair(const Corners& corners, const Vector2& a, const Vector2& b, double sign) {
  double nearest = std::numeric_limits<double>::infinity();
  Vector2 away(0.0, 0.0);
  Contact contact;
  const auto consider = [&](const Vector2& of_outline, const Vector2& to_obstacle) {
    const double squared = to_obstacle.squaredNorm();
    if (squared >= nearest) return;
    nearest = squared;
    away = to_obstacle;
    contact.point = of_outline;
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2& p = corners[i];
    const Vector2& q = after(corners, i);
    const Vector2 to_a = away_from(p, q, a);
    consider(a - to_a, to_a);
    if (a == b) continue;
    const Vector2 to_b = away_from(p, q, b);
    consider(b - to_b, to_b);
    consider(p, -away_from(a, b, p));
  }
  const double length = std::sqrt(nearest);
  contact.distance = sign * length;
  if (length > 1e-9) contact.normal = away * (sign / length);
  return contact;
}

// Of a segment that meets the polygon: the least way out along a normal of either.
Contact least_way_out(const Corners& corners, const Vector2& a, const Vector2& b) {
  double area = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) area += cross(corners[i], after(corners, i));
  Contact best{.distance = -std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 edge = after(corners, i) - corners[i];
    const double length = edge.norm();
    if (length == 0.0) continue;
    const Vector2 outward = left_of(edge) * ((area > 0.0 ? -1.0 : 1.0) / length);
    const double at_a = outward.dot(a - corners[i]), at_b = outward.dot(b - corners[i]);
    if (std::min(at_a, at_b) > best.distance) best = {std::min(at_a, at_b), outward, at_a < at_b ? a : b};
  }
  const Vector2 side = left_of((b - a).normalized());
  for (const double sign : {1.0, -1.0}) {
    const Vector2 towards = sign * side;  // the obstacle lies this way from the footprint
    Contact out{.distance = std::numeric_limits<double>::infinity(), .normal = towards};
    for (const Vector2& corner : corners) {
      const double beyond = towards.dot(a - corner);
      if (beyond < out.distance) out = {beyond, towards, corner};
    }
    if (out.distance > best.distance) best = out;
  }
  best.distance = std::min(best.distance, 0.0);
  return best;
}

Contact contact_of(const Corners& corners, const Vector2& a, const Vector2& b) {
  bool meets = holds(corners, a);
  if (a == b) return nearest_pair(corners, a, b, meets ? -1.0 : 1.0);
  for (std::size_t i = 0; i < corners.size() && !meets; ++i) {
    meets = cross_each_other(corners[i], after(corners, i), a, b);
  }
  return meets ? least_way_out(corners, a, b) : nearest_pair(corners, a, b, 1.0);
}

}  // namespace

FootprintDistance distance_to(const Vector2& point, const Capsule& capsule) {
  const Vector2 away = away_from(capsule.a, capsule.b, point);
  const double distance = away.norm();
  return {distance - capsule.radius, distance > 1e-9 ? Vector2(away / distance) : Vector2(0.0, 0.0), 0.0};
}

FootprintDistance distance_to(const Footprint& footprint, const Pose2& pose, const Capsule& capsule) {
  if (!footprint.is_polygon()) {
    return distance_to(pose.position(), {capsule.a, capsule.b, capsule.radius + footprint.radius});
  }
  const Vector2 u = direction(pose.theta);
  const auto to_base = [&](const Vector2& p) {
    const Vector2 d = p - pose.position();
    return Vector2(u.dot(d), cross(u, d));
  };
  const Vector2 a = to_base(capsule.a);
  const Contact contact = contact_of(footprint.polygon, a, capsule.a == capsule.b ? a : to_base(capsule.b));
  const Vector2 normal = contact.normal.x() * u + contact.normal.y() * left_of(u);
  return {contact.distance - capsule.radius, -normal, -contact.normal.dot(left_of(contact.point))};
}

double gap_to(const Footprint& footprint, const Pose2& pose, const Capsule& capsule, double enough) {
  const double of_disc =
      away_from(capsule.a, capsule.b, pose.position()).norm() - footprint.radius - capsule.radius;
  if (!footprint.is_polygon() || of_disc >= enough) return of_disc;
  return distance_to(footprint, pose, capsule).distance;
}

}  // namespace bw
