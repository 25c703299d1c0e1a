#include "components/local_planner/hrvo/cones.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/nearest_point.hpp"

namespace bw::hrvo {
namespace {

constexpr double kStraightTie = 1e-9;  // [m^2/s] below it nobody is left or right: pass right
constexpr double kTouching = 1e-9;     // of the radius: nearer, the legs are opposite and never meet

struct Legs {
  Vector2 right;
  Vector2 left;
};

// Tangents from the origin to the disc at `p`, |p| > radius.
Legs tangents(const Vector2& p, double radius) {
  const double distance = p.norm();
  const Vector2 ahead = p / distance;
  const double sine = radius / distance;
  const double cosine = std::sqrt(std::max(0.0, (1.0 - sine) * (1.0 + sine)));
  const Vector2 across = sine * Vector2(-ahead.y(), ahead.x());
  return {cosine * ahead - across, cosine * ahead + across};
}

// Outermost of the tangents to the discs at both ends: their hull is the swollen segment.
Legs tangents_to_hull(const Segment& core, double radius) {
  const Legs a = tangents(core.a, radius);
  const Legs b = tangents(core.b, radius);
  return {cross(a.right, b.right) < 0.0 ? b.right : a.right, cross(a.left, b.left) > 0.0 ? b.left : a.left};
}

VelocityCone half_plane(const Neighbour& n, const Vector2& towards, const RobotMotion& robot) {
  const double share = n.shares ? 0.5 : 1.0;
  const double parting_speed = share * std::max(0.0, n.radius - n.distance) / kTimeStep;
  const Vector2 apex = n.velocity + (1.0 - share) * (robot.velocity - n.velocity);
  return {apex - parting_speed * towards, {towards.y(), -towards.x()}, {-towards.y(), towards.x()}};
}

Vector2 hybrid_apex(const Neighbour& n, const Vector2& p, const Legs& legs, const RobotMotion& robot,
                    const HrvoOptions& options) {
  const Vector2 v = robot.velocity - n.velocity;
  const double sine = cross(legs.right, legs.left);
  const Vector2 deciding =
      options.passing_side == PassingSide::preferred ? Vector2(robot.preferred - n.velocity) : v;
  const double side = cross(p, deciding);
  const bool pass_left = side > kStraightTie;
  return pass_left ? n.velocity + legs.right * (0.5 * cross(v, legs.left) / sine)
                   : n.velocity + legs.left * (0.5 * cross(legs.right, v) / sine);
}

}  // namespace

VelocityCone cone_of(const Neighbour& n, const RobotMotion& robot, const HrvoOptions& options) {
  const Vector2 nearest = nearest_point(n.core, robot.position) - robot.position;
  const double distance = nearest.norm();
  const Vector2 towards = distance > 0.0 ? Vector2(nearest / distance) : direction(robot.heading);
  VelocityCone cone = half_plane(n, towards, robot);
  double widening = 1.0;  // of the sensing margin, so that it is kept at right angles to the legs
  if (distance > n.radius * (1.0 + kTouching)) {
    const Legs legs = tangents_to_hull({n.core.a - robot.position, n.core.b - robot.position}, n.radius);
    cone = {n.shares ? hybrid_apex(n, nearest, legs, robot, options) : n.velocity, legs.right, legs.left};
    widening = distance / n.radius;
  }
  cone.apex -= options.sensing_margin * widening * towards;
  return cone;
}

}  // namespace bw::hrvo
