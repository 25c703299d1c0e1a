// The one arc of this project: a base that travels `distance` [m] (negative: backward) while it rotates by
// `rotation` [rad], both at a constant rate (README.md 2.1; (1.1) takes the chord for the arc). Its
// derivatives, and the arc between two poses.
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "runtime/base/pose2.hpp"

namespace bw {

/// sin(h) / h: chord over arc of a rotation by 2 h.
inline double sinc(double h) { return std::abs(h) < 1e-6 ? 1.0 - h * h / 6.0 : std::sin(h) / h; }

/// x+ = x + s sinc(t/2) cos(theta + t/2), y+ alike with sin, theta+ = theta + t.
inline Pose2 advance_arc(const Pose2& X, double distance, double rotation) {
  const double half = rotation / 2.0;
  const double chord = distance * sinc(half);
  return {X.x + chord * std::cos(X.theta + half), X.y + chord * std::sin(X.theta + half),
          wrap_angle(X.theta + rotation)};
}

struct ArcStep {
  Pose2 pose;
  Eigen::Matrix3d by_pose;              ///< d pose / d start
  Eigen::Matrix<double, 3, 2> by_step;  ///< d pose / d (distance, rotation)
};

/// advance_arc() with its derivatives.
inline ArcStep arc_step(const Pose2& X, double distance, double rotation) {
  const double half = rotation / 2.0;
  const double chord = sinc(half);
  // d sinc / dh; its closed form loses digits near zero.
  const double slope =
      std::abs(half) < 1e-3 ? -half / 3.0 * (1.0 - half * half / 10.0) : (std::cos(half) - chord) / half;
  const double c = std::cos(X.theta + half);
  const double s = std::sin(X.theta + half);

  ArcStep arc;
  arc.pose = advance_arc(X, distance, rotation);
  arc.by_pose << 1.0, 0.0, -distance * chord * s,  //
      0.0, 1.0, distance * chord * c,              //
      0.0, 0.0, 1.0;
  arc.by_step << chord * c, distance / 2.0 * (slope * c - chord * s),  //
      chord * s, distance / 2.0 * (slope * s + chord * c),             //
      0.0, 1.0;
  return arc;
}

struct ArcTravel {
  double distance = 0.0;  ///< [m]
  double rotation = 0.0;  ///< [rad]
};

/// The arc that rotates by the difference in heading and whose chord is the path between the poses along the
/// mean heading. What lies across that is no motion of a differential drive, and is left out.
inline ArcTravel arc_between(const Pose2& from, const Pose2& to) {
  const Pose2 moved = inverse(from) * to;
  const double half = moved.theta / 2.0;
  return {moved.position().dot(direction(half)) / sinc(half), moved.theta};
}

}  // namespace bw
