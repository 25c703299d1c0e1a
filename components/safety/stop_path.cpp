#include "components/safety/stop_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/differential_drive.hpp"
#include "components/model/stopping.hpp"
#include "components/model/transform2.hpp"

namespace bw::safety {
namespace {

constexpr double kStep = 0.02;  // [s]

double towards(double from, double to, double step) { return from + std::clamp(to - from, -step, step); }

/// A step later, as motor control has it (components/motor_control/velocity_limiter.hpp), but without limit
/// of jerk.
Twist2 later(const StopPath& path, const Twist2& twist, const Told& told) {
  const Twist2& to = told.command;
  const Twist2 braking =
      told.action != Action::do_nothing
          ? braking_towards(to, twist, path.limits.stop_deceleration, path.wheel_separation)
          : Twist2{};
  const double v = to.v * twist.v < 0.0 && braking.v > 0.0 ? 0.0 : to.v;  // backward comes after rest
  return {
      towards(twist.v, v, (braking.v > 0.0 ? braking.v : path.limits.acc_max) * kStep),
      towards(twist.omega, to.omega, (braking.omega > 0.0 ? braking.omega : path.limits.alpha_max) * kStep)};
}

struct Side {
  Vector2 corner, outward;
};

std::vector<Side> sides_of(const std::vector<Vector2>& corners) {
  std::vector<Side> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 side = corners[(i + 1) % corners.size()] - corners[i];
    sides.push_back({corners[i], Vector2(side.y(), -side.x()) / side.norm()});
  }
  return sides;
}

/// How fast a disc, or the polygon of `sides`, moves onto `p`, which it covers; nothing where it does not.
double closing_on(double radius, const std::vector<Side>& sides, const Twist2& twist, const Vector2& p) {
  const double squared = p.squaredNorm();
  if (squared >= radius * radius) return 0.0;
  const Vector2 velocity(twist.v - twist.omega * p.y(), twist.omega * p.x());
  if (sides.empty()) return squared > 0.0 ? p.dot(velocity) / std::sqrt(squared) : 0.0;
  double least = std::numeric_limits<double>::infinity();
  double closing = 0.0;
  for (const Side& side : sides) {
    const double inside = side.outward.dot(side.corner - p);
    if (inside <= 0.0) return 0.0;
    if (inside < least) {
      least = inside;
      closing = side.outward.dot(velocity);
    }
  }
  return closing;
}

}  // namespace

double closing_speed(const StopPath& path, const Footprint& footprint, const Twist2& now, const Told& told,
                     const std::vector<SeenPoint>& points) {
  // The outline stays within its radius around base_link, which goes no farther than this.
  const double fastest = std::max(std::abs(now.v), std::abs(told.command.v));
  const double turn_rate = std::max(std::abs(now.omega), std::abs(told.command.omega));
  const double braking_time =
      (fastest + 0.5 * path.wheel_separation * turn_rate) / path.limits.stop_deceleration;
  const double longest = path.reaction_time + braking_time + 2.0 * kStep;
  const double reach = footprint.radius + fastest * (longest - 0.5 * braking_time);
  std::vector<Vector2> near;
  for (const SeenPoint& point : points)
    if (point.position.squaredNorm() < reach * reach) near.push_back(point.position);
  if (near.empty()) return 0.0;
  const std::vector<Side> sides = sides_of(footprint.polygon);
  const Told stop{{}, Action::stop};
  double worst = 0.0;
  Pose2 X;
  Twist2 twist = now;
  for (double t = 0.0; t < longest && worst <= kGentle; t += kStep) {
    const Transform2 X_inverse(inverse(X));
    for (const Vector2& point : near)
      worst = std::max(worst, closing_on(footprint.radius, sides, twist, X_inverse * point));
    if (t >= path.reaction_time && twist == Twist2{}) break;
    X = advance_exact(X, twist, kStep);
    twist = later(path, twist, t < path.reaction_time ? told : stop);
  }
  return worst;
}

}  // namespace bw::safety
