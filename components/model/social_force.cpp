#include "components/model/social_force.hpp"

#include <cmath>

namespace bw {

Vector2 desired_force(const SocialForceOptions& options, const Vector2& desired_velocity,
                      const Vector2& velocity) {
  return options.kDesiredFactor / options.kRelaxationTime * (desired_velocity - velocity);
}

Vector2 social_force(const SocialForceOptions& options, const Vector2& p_ij, const Vector2& v_ij) {
  const double distance = p_ij.norm();
  if (distance == 0.0) return {0.0, 0.0};
  const Vector2 e = p_ij / distance;
  const Vector2 D = options.kLambda * v_ij + e;
  const double D_norm = D.norm();
  if (D_norm == 0.0) return {0.0, 0.0};
  const Vector2 t = D / D_norm;
  const double B = options.kGamma * D_norm;
  const double q = std::atan2(cross(t, e), t.dot(e));
  const auto strength = [&](double width) { return std::exp(-distance / B - std::pow(width * B * q, 2)); };
  const double slowing = -strength(options.kNPrime);
  const double sideways = (q >= 0.0 ? -1.0 : 1.0) * strength(options.kN);
  return options.social_factor * (slowing * t + sideways * Vector2(-t.y(), t.x()));
}

Vector2 group_force(const SocialForceOptions& options, const Vector2& to_centre, int members) {
  const double distance = to_centre.norm();
  if (distance <= 0.5 * (members - 1)) return {0.0, 0.0};
  return options.kGroupPull / distance * to_centre;
}

Vector2 obstacle_force(const SocialForceOptions& options, const Vector2& from_wall, double radius) {
  const double distance = from_wall.norm();
  if (distance == 0.0) return {0.0, 0.0};
  return options.kObstacleFactor * std::exp(-(distance - radius) / options.obstacle_sigma) / distance *
         from_wall;
}

}  // namespace bw
