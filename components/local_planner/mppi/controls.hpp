// The sequence of velocities that MPPI improves from cycle to cycle: kept within limits, smoothed, shifted in
// time.
#pragma once

#include <array>

#include <Eigen/Core>

#include "components/model/limits.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::mppi {

/// Velocities [m/s], [rad/s] at the times 0, dt, 2 dt, ... from now, and those of the four steps before.
class Controls {
 public:
  /// Standing, before as well.
  explicit Controls(Eigen::Index steps) { reset(steps); }
  void reset(Eigen::Index steps);

  Eigen::Index steps() const { return v.size(); }
  /// At `steps` times dt from now: linear between them; before the four steps and after the last one the
  /// nearest.
  Twist2 at(double steps) const;

  /// Into the limits, and no faster changes than dt [s] allows.
  void limit(const Limits& limits, double dt);
  /// Savitzky-Golay: each one becomes what the parabola nearest to it and four on either side has there.
  /// Beyond the end the last one goes on; that itself stays. Nothing with fewer than 21 steps.
  void smooth();
  /// `steps` times dt later; the last one goes on.
  void shift(double steps);

  Eigen::ArrayXd v, omega;

 private:
  std::array<Twist2, 4> before_{};  ///< the oldest first
};

}  // namespace bw::mppi
