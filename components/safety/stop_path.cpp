#include "components/safety/stop_path.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/model/differential_drive.hpp"
#include "components/model/stopping.hpp"

namespace bw::safety {
namespace {

constexpr double kStep = 0.02;  // [s]

double towards(double from, double to, double step) { return from + std::clamp(to - from, -step, step); }

/// How fast the outline moves onto `p`, which it covers; nothing where it does not.
double closing_on(const Footprint& footprint, const Twist2& twist, const Vector2& p) {
  const Vector2 velocity(twist.v - twist.omega * p.y(), twist.omega * p.x());
  if (!footprint.is_polygon()) {
    const double distance = p.norm();
    return distance < footprint.radius && distance > 0.0 ? p.dot(velocity) / distance : 0.0;
  }
  double least = std::numeric_limits<double>::infinity();
  double closing = 0.0;
  const std::vector<Vector2>& corners = footprint.polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vector2 side = corners[(i + 1) % corners.size()] - corners[i];
    const Vector2 outward = Vector2(side.y(), -side.x()) / side.norm();
    const double inside = outward.dot(corners[i] - p);
    if (inside <= 0.0) return 0.0;
    if (inside < least) {
      least = inside;
      closing = outward.dot(velocity);
    }
  }
  return closing;
}

}  // namespace

double closing_speed(const StopPath& path, const Footprint& footprint, const Twist2& now,
                     const Twist2& command, const std::vector<SeenPoint>& points) {
  // No point of the outline moves faster than its centre and its farthest corner together.
  const double fastest = std::max(std::abs(now.v) + footprint.radius * std::abs(now.omega),
                                  std::abs(command.v) + footprint.radius * std::abs(command.omega));
  const double wheel = std::abs(now.v) + std::abs(command.v) +
                       0.5 * path.wheel_separation * (std::abs(now.omega) + std::abs(command.omega));
  const double longest = path.reaction_time + wheel / path.limits.stop_deceleration + 2.0 * kStep;
  const double reach = footprint.radius + fastest * longest;
  std::vector<Vector2> near;
  for (const SeenPoint& point : points)
    if (point.position.squaredNorm() < reach * reach) near.push_back(point.position);
  if (near.empty()) return 0.0;
  double worst = 0.0;
  Pose2 X;
  Twist2 twist = now;
  for (double t = 0.0; t < longest && worst <= kGentle; t += kStep) {
    const Pose2 X_inverse = inverse(X);
    for (const Vector2& point : near)
      worst = std::max(worst, closing_on(footprint, twist, X_inverse * point));
    X = advance_exact(X, twist, kStep);
    if (t < path.reaction_time) {
      twist = {towards(twist.v, command.v, path.limits.acc_max * kStep),
               towards(twist.omega, command.omega, path.limits.alpha_max * kStep)};
    } else {
      const Twist2 braking = braking_of(twist, path.limits.stop_deceleration, path.wheel_separation);
      twist = {towards(twist.v, 0.0, braking.v * kStep), towards(twist.omega, 0.0, braking.omega * kStep)};
      if (twist == Twist2{}) break;
    }
  }
  return worst;
}

}  // namespace bw::safety
