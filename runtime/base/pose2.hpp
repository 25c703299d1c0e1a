// Planar poses and twists. x forward, y left, theta counter-clockwise in (-pi, pi]; SI units.
#pragma once

#include <cmath>
#include <numbers>

#include <Eigen/Core>

namespace bw {

using Vector2 = Eigen::Vector2d;

/// Maps any finite angle [rad] to (-pi, pi].
inline double wrap_angle(double angle) {
  constexpr double kTwoPi = 2.0 * std::numbers::pi;
  if (angle > -std::numbers::pi && angle <= std::numbers::pi) return angle;  // nearly always: no division
  double a = std::remainder(angle, kTwoPi);
  return a <= -std::numbers::pi ? a + kTwoPi : a;
}

inline Vector2 direction(double theta) { return {std::cos(theta), std::sin(theta)}; }
inline double cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Pose X_AB of a frame B in a frame A: position [m] and heading [rad].
struct Pose2 {
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;

  Vector2 position() const { return {x, y}; }
  bool operator==(const Pose2&) const = default;
};

/// Body velocity: forward [m/s] and counter-clockwise turn rate [rad/s].
struct Twist2 {
  double v = 0.0;
  double omega = 0.0;
  bool operator==(const Twist2&) const = default;
};

/// X_AC = X_AB * X_BC.
inline Pose2 operator*(const Pose2& X_AB, const Pose2& X_BC) {
  const double c = std::cos(X_AB.theta);
  const double s = std::sin(X_AB.theta);
  return {X_AB.x + c * X_BC.x - s * X_BC.y, X_AB.y + s * X_BC.x + c * X_BC.y,
          wrap_angle(X_AB.theta + X_BC.theta)};
}

/// p_A = X_AB * p_B.
inline Vector2 operator*(const Pose2& X_AB, const Vector2& p_B) {
  const double c = std::cos(X_AB.theta);
  const double s = std::sin(X_AB.theta);
  return {X_AB.x + c * p_B.x() - s * p_B.y(), X_AB.y + s * p_B.x() + c * p_B.y()};
}

inline Pose2 inverse(const Pose2& X_AB) {
  const double c = std::cos(X_AB.theta);
  const double s = std::sin(X_AB.theta);
  return {-c * X_AB.x - s * X_AB.y, s * X_AB.x - c * X_AB.y, wrap_angle(-X_AB.theta)};
}

/// Rotates a free vector (a velocity) from B into A; no translation.
inline Vector2 rotate(const Pose2& X_AB, const Vector2& v_B) {
  const double c = std::cos(X_AB.theta);
  const double s = std::sin(X_AB.theta);
  return {c * v_B.x() - s * v_B.y(), s * v_B.x() + c * v_B.y()};
}

inline bool is_finite(const Pose2& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.theta);
}
inline bool is_finite(const Twist2& t) { return std::isfinite(t.v) && std::isfinite(t.omega); }

}  // namespace bw
