// What the base does with many sequences of velocities at once: all samples side by side, one column for each
// step, so that the loops run over neighbours in memory.
#pragma once

#include <Eigen/Core>

#include "components/local_planner/mppi/controls.hpp"
#include "components/model/limits.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::mppi {

/// Rows are samples. Poses in base_link of now, at the end of each step; headings are not wrapped.
struct Rollouts {
  Eigen::ArrayXXd command_v, command_omega;  ///< sampled
  Eigen::ArrayXXd v, omega;                  ///< driven all through a step
  Eigen::ArrayXXd x, y, theta;

  void resize(Eigen::Index samples, Eigen::Index steps);
  Eigen::Index samples() const { return x.rows(); }
  Eigen::Index steps() const { return x.cols(); }
};

/// From `now` on: the first step is driven at `now`, step k at command k - 1, as far as the accelerations
/// allow. Speeds are not cut: that is the constraint critic's. Poses by exact arcs (model/README.md 2.1).
void roll_out(Rollouts& rollouts, const Twist2& now, const Limits& limits, double dt);

/// Every command but the last, which nobody drives, becomes what is driven of it.
void cut_commands(Rollouts& rollouts);

}  // namespace bw::mppi
