#include "components/local_planner/mppi/optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "components/local_planner/mppi/critics.hpp"
#include "components/local_planner/mppi/side.hpp"

namespace bw::mppi {
namespace {

constexpr double kPruned = 1.7;  // [m] of plan that is looked at, as shipped
constexpr double kBeyond =
    0.3;  // [m] of plan beyond the travel of a motion at top speed: 1.7 - 2.8 s 0.5 m/s of Nav2's file
constexpr double kMapMargin = 0.5;      // [m] of costmap beyond that of the fastest samples
constexpr std::int64_t kMaxRounds = 4;  // that a long control period brings
constexpr double kFastSamples = 2.0;    // standard deviations
constexpr int kRetries = 1;             // from standing, when every sample collides

// Nav2 samples once in each model_dt (iteration_count): as often here in a control period of several.
std::int64_t rounds_of(const MppiOptions& options, double control_period) {
  const auto steps = static_cast<std::int64_t>(std::lround(control_period / options.model_dt));
  return std::clamp<std::int64_t>(steps, 1, kMaxRounds);
}

/// Everything that the critics look at, of one problem.
class Judge {
 public:
  Judge(const PlanningProblem& problem, const MppiOptions& options)
      : problem_(problem),
        options_(options),
        horizon_(static_cast<double>(options.time_steps) * options.model_dt),
        reach_(std::max({problem.limits.v_max, problem.limits.v_back_max, std::abs(problem.twist.v)}) *
               horizon_),
        costmap_(problem, options.inflation, reach_ + kFastSamples * options.vx_std * horizon_ + kMapMargin,
                 !options.predict_movers),
        predicted_(options.predict_movers ? problem : PlanningProblem{}, options.inflation, reach_, horizon_),
        path_(local_path(problem.plan, problem.pose, std::max(kPruned, reach_ + kBeyond), costmap_)) {}

  /// How many of the motions touch nothing.
  Eigen::Index add_costs(const Rollouts& motions, Eigen::ArrayXd& costs) const {
    const Pose2& goal = problem_.plan.back();
    const Eigen::Index end = motions.steps() - 1;
    const CriticScene scene{.goal = inverse(problem_.pose) * goal,
                            .goal_distance = problem_.goal_is_final
                                                 ? (goal.position() - problem_.pose.position()).norm()
                                                 : std::numeric_limits<double>::infinity(),
                            .path = path_,
                            .costmap = costmap_,
                            .predicted = predicted_,
                            .limits = problem_.limits,
                            .dt = options_.model_dt,
                            .furthest = furthest_reached(path_, motions.x.col(end), motions.y.col(end))};
    add_constraint_cost(options_.constraint, scene, motions, costs);
    const Eigen::Index free = add_cost_cost(options_.cost, scene, motions, costs);
    add_goal_cost(options_.goal, scene, motions, costs);
    add_goal_angle_cost(options_.goal_angle, scene, motions, costs);
    add_path_align_cost(options_.path_align, scene, motions, costs);
    add_path_follow_cost(options_.path_follow, scene, motions, costs);
    add_path_angle_cost(options_.path_angle, scene, motions, costs);
    add_prefer_forward_cost(options_.prefer_forward, scene, motions, costs);
    return free;
  }

 private:
  const PlanningProblem& problem_;
  const MppiOptions& options_;
  double horizon_;
  double reach_;
  Costmap costmap_;
  PredictedCosts predicted_;
  LocalPath path_;
};

}  // namespace

Eigen::ArrayXd softmax_weights(const Eigen::ArrayXd& costs, double temperature) {
  Eigen::ArrayXd weights = (-(costs - costs.minCoeff()) / temperature).exp();
  return weights / weights.sum();
}

void add_deviation_cost(const Eigen::ArrayXXd& commands, const Eigen::ArrayXd& mean, double gamma, double std,
                        Eigen::ArrayXd& costs) {
  const double scale = gamma / (std * std);
  for (Eigen::Index k = 0; k < mean.size(); ++k) costs += scale * mean[k] * (commands.col(k) - mean[k]);
}

Optimizer::Optimizer(const MppiOptions& options)
    : options_(options), controls_(options.time_steps), normal_(options.seed) {
  samples_.resize(options.batch_size, options.time_steps);
}

void Optimizer::reset() {
  controls_.reset(options_.time_steps);
  normal_ = StandardNormal(options_.seed);
  noise_v_.resize(0, 0);
}

void Optimizer::continue_from(const Optimizer& other) {
  const MppiOptions& theirs = other.options_;
  if (theirs.time_steps != options_.time_steps || theirs.model_dt != options_.model_dt) return;
  controls_ = other.controls_;
  if (theirs.seed != options_.seed || theirs.batch_size != options_.batch_size) return;
  normal_ = other.normal_;
  noise_v_ = other.noise_v_;
  noise_omega_ = other.noise_omega_;
}

void Optimizer::draw_noise() {
  noise_v_.resize(options_.batch_size, options_.time_steps);
  noise_omega_.resize(options_.batch_size, options_.time_steps);
  for (Eigen::ArrayXXd* noise : {&noise_v_, &noise_omega_})
    normal_.fill(noise->data(), static_cast<std::size_t>(noise->size()));
}

void Optimizer::sample(double side) {
  if (options_.regenerate_noises || noise_v_.size() == 0) draw_noise();
  for (Eigen::Index k = 0; k < controls_.steps(); ++k) {
    samples_.command_v.col(k) = controls_.v[k] + options_.vx_std * noise_v_.col(k);
    samples_.command_omega.col(k) = controls_.omega[k] + side * options_.wz_std * noise_omega_.col(k);
  }
}

Optimizer::Outcome Optimizer::improve(const PlanningProblem& problem) {
  const Judge judge(problem, options_);
  const double side = side_of(problem);
  const std::int64_t rounds = rounds_of(options_, problem.control_period);
  Outcome outcome;
  for (int attempt = 0; attempt <= kRetries; ++attempt) {
    for (std::int64_t i = 0; i < rounds; ++i) {
      if (outcome.iterations >= problem.budget.max_iterations) break;
      ++outcome.iterations;
      sample(side);
      roll_out(samples_, problem.twist, problem.limits, options_.model_dt);
      if (options_.clamp_raw_controls) cut_commands(samples_);
      costs_ = Eigen::ArrayXd::Zero(options_.batch_size);
      outcome.found = judge.add_costs(samples_, costs_) > 0;
      add_deviation_cost(samples_.command_v, controls_.v, options_.kGamma, options_.vx_std, costs_);
      add_deviation_cost(samples_.command_omega, controls_.omega, options_.kGamma, options_.wz_std, costs_);
      weights_ = softmax_weights(costs_, options_.temperature);
      controls_.v = samples_.command_v.matrix().transpose() * weights_.matrix();
      controls_.omega = samples_.command_omega.matrix().transpose() * weights_.matrix();
      controls_.limit(problem.limits, options_.model_dt);
    }
    if (outcome.found) {
      controls_.smooth();
      return outcome;
    }
    controls_.reset(options_.time_steps);
    if (outcome.iterations >= problem.budget.max_iterations) break;
  }
  return outcome;
}

}  // namespace bw::mppi
