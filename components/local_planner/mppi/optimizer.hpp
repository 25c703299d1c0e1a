// Model predictive path integral control (Williams et al. 2017) as Nav2 has it (theory.md 5.8): sample around
// the motion of the last cycle, roll out, let the critics judge, and take the mean with weights that fall
// with the cost.
#pragma once

#include <Eigen/Core>

#include "components/local_planner/mppi/controls.hpp"
#include "components/local_planner/mppi/mppi_options.hpp"
#include "components/local_planner/mppi/rollouts.hpp"
#include "components/local_planner/mppi/standard_normal.hpp"
#include "components/model/planning.hpp"

namespace bw::mppi {

/// exp(-(cost - the smallest) / temperature), their sum 1.
Eigen::ArrayXd softmax_weights(const Eigen::ArrayXd& costs, double temperature);

/// gamma / std^2 times the sum over the steps of `mean` (`commands` - `mean`), for each sample: what it costs
/// to leave the mean.
void add_deviation_cost(const Eigen::ArrayXXd& commands, const Eigen::ArrayXd& mean, double gamma, double std,
                        Eigen::ArrayXd& costs);

class Optimizer {
 public:
  explicit Optimizer(const MppiOptions& options);

  /// As new: standing, the first samples again.
  void reset();
  /// Goes on from another one's motion and samples where both are of the same kind.
  void continue_from(const Optimizer& other);

  struct Outcome {
    bool found = false;  ///< some sample touches nothing
    int iterations = 0;
  };
  /// Improves controls() for a sound problem with a plan. When every sample collides: from standing again,
  /// and after the last try not found, standing. Keeps to the budget.
  Outcome improve(const PlanningProblem& problem);

  Controls& controls() { return controls_; }
  const Controls& controls() const { return controls_; }
  /// Of the last iteration.
  const Rollouts& samples() const { return samples_; }
  const Eigen::ArrayXd& costs() const { return costs_; }
  const Eigen::ArrayXd& weights() const { return weights_; }

 private:
  void sample(double side);
  void draw_noise();

  MppiOptions options_;
  Controls controls_;
  StandardNormal normal_;
  Eigen::ArrayXXd noise_v_, noise_omega_;
  Rollouts samples_;
  Eigen::ArrayXd costs_, weights_;
};

}  // namespace bw::mppi
