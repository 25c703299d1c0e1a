// Differential-drive kinematics: equation (1.1) of the dissertation summary and its wheel relations
// (README.md 2.1).
#pragma once

#include "components/model/arc.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// Ground speeds of the two wheels [m/s].
struct WheelSpeeds {
  double left = 0.0;
  double right = 0.0;
  bool operator==(const WheelSpeeds&) const = default;
};

/// Of the two wheels [m].
struct WheelRadii {
  double left = 0.0;
  double right = 0.0;
};

/// v = (v_R + v_L) / 2, omega = (v_R - v_L) / b, b = wheel separation [m].
inline Twist2 to_twist(const WheelSpeeds& w, double separation) {
  return {(w.right + w.left) / 2.0, (w.right - w.left) / separation};
}

/// v_R = v + omega b / 2, v_L = v - omega b / 2.
inline WheelSpeeds to_wheel_speeds(const Twist2& t, double separation) {
  return {t.v - t.omega * separation / 2.0, t.v + t.omega * separation / 2.0};
}

/// The pose after holding (v, omega) for dt [s]: an exact arc, where the midpoint form (1.1) takes the chord
/// for it.
inline Pose2 advance_exact(const Pose2& X, const Twist2& t, double dt) {
  return advance_arc(X, t.v * dt, t.omega * dt);
}

}  // namespace bw
