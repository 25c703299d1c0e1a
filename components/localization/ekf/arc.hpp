// Exact arc and its derivatives: the pose after travelling `distance` [m] while turning `turn` [rad].
#pragma once

#include <cmath>

#include <Eigen/Core>

#include "runtime/base/pose2.hpp"

namespace bw::localization {

struct ArcStep {
  Pose2 pose;
  Eigen::Matrix3d by_pose;              ///< d pose / d start
  Eigen::Matrix<double, 3, 2> by_step;  ///< d pose / d (distance, turn)
};

/// x+ = x + s sinc(t/2) cos(theta + t/2), y+ alike with sin, theta+ = theta + t (book 2.1 on the exact arc).
inline ArcStep advance_arc(const Pose2& X, double s, double t) {
  const double h = t / 2.0;
  const bool small = std::abs(h) < 1e-3;
  const double sinc = small ? 1.0 - h * h / 6.0 * (1.0 - h * h / 20.0) : std::sin(h) / h;
  // d sinc / dh; the closed form loses digits near zero.
  const double slope = small ? -h / 3.0 * (1.0 - h * h / 10.0) : (std::cos(h) - sinc) / h;
  const double c = std::cos(X.theta + h);
  const double sn = std::sin(X.theta + h);

  ArcStep arc;
  arc.pose = {X.x + s * sinc * c, X.y + s * sinc * sn, wrap_angle(X.theta + t)};
  arc.by_pose << 1.0, 0.0, -s * sinc * sn,  //
      0.0, 1.0, s * sinc * c,               //
      0.0, 0.0, 1.0;
  arc.by_step << sinc * c, s / 2.0 * (slope * c - sinc * sn),  //
      sinc * sn, s / 2.0 * (slope * sn + sinc * c),            //
      0.0, 1.0;
  return arc;
}

}  // namespace bw::localization
