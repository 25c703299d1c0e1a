// Differential-drive kinematics: equation (1.1) of the dissertation summary and its wheel relations
// (book 2.1).
#pragma once

#include "runtime/base/pose2.hpp"

namespace bw {

/// Ground speeds of the two wheels [m/s].
struct WheelSpeeds {
  double left = 0.0;
  double right = 0.0;
  bool operator==(const WheelSpeeds&) const = default;
};

/// v = (v_R + v_L) / 2, omega = (v_R - v_L) / b, b = wheel separation [m].
inline Twist2 to_twist(const WheelSpeeds& w, double separation) {
  return {(w.right + w.left) / 2.0, (w.right - w.left) / separation};
}

/// v_R = v + omega b / 2, v_L = v - omega b / 2.
inline WheelSpeeds to_wheel_speeds(const Twist2& t, double separation) {
  return {t.v - t.omega * separation / 2.0, t.v + t.omega * separation / 2.0};
}

/// Midpoint form (1.1): the pose after holding (v, omega) for dt [s].
inline Pose2 advance_midpoint(const Pose2& X, const Twist2& t, double dt) {
  const double c = X.theta + t.omega * dt / 2.0;
  return {X.x + t.v * dt * std::cos(c), X.y + t.v * dt * std::sin(c), wrap_angle(X.theta + t.omega * dt)};
}

/// Exact arc: chord of length v dt sinc(omega dt / 2) along the mid heading; valid for omega = 0.
inline Pose2 advance_exact(const Pose2& X, const Twist2& t, double dt) {
  const double half = t.omega * dt / 2.0;
  const double sinc = std::abs(half) < 1e-6 ? 1.0 - half * half / 6.0 : std::sin(half) / half;
  const double chord = t.v * dt * sinc;
  return {X.x + chord * std::cos(X.theta + half), X.y + chord * std::sin(X.theta + half),
          wrap_angle(X.theta + t.omega * dt)};
}

}  // namespace bw
