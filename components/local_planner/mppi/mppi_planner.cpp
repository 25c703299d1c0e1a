#include "components/local_planner/mppi/mppi_planner.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/planner_registry.hpp"

namespace bw::mppi {
namespace {

constexpr std::size_t kShownSamples = 5;  // the best ones
constexpr Eigen::Index kShownStep = 4;    // every how many-th pose of a sample is shown

/// Sample `row` as points in the frame of the problem, every `stride`-th step.
std::vector<TrajectoryPoint> as_trajectory(const Rollouts& rollouts, Eigen::Index row, Eigen::Index stride,
                                           double dt, const PlanningProblem& problem) {
  std::vector<TrajectoryPoint> trajectory{{0.0, problem.pose, problem.twist}};
  for (Eigen::Index k = stride - 1; k < rollouts.steps(); k += stride) {
    trajectory.push_back(
        {dt * static_cast<double>(k + 1),
         problem.pose * Pose2{rollouts.x(row, k), rollouts.y(row, k), rollouts.theta(row, k)},
         {rollouts.v(row, k), rollouts.omega(row, k)}});
  }
  return trajectory;
}

std::vector<TrajectoryPoint> as_trajectory(const Controls& controls, double dt,
                                           const PlanningProblem& problem) {
  Rollouts one;
  one.resize(1, controls.steps());
  one.command_v.row(0) = controls.v;
  one.command_omega.row(0) = controls.omega;
  roll_out(one, problem.twist, problem.limits, dt);
  return as_trajectory(one, 0, 1, dt, problem);
}

}  // namespace

PlanningResult MppiPlanner::drive(const PlanningProblem& problem) {
  const Optimizer::Outcome outcome = optimizer_.improve(problem);
  PlanningResult result;
  if (!outcome.found) {
    result = stopped(problem, PlanningStatus::infeasible, "every sampled motion collides");
    if (options_.check_motion) evade(problem, driving(), result);
    result.iterations = outcome.iterations;
    return result;
  }
  const Controls& controls = optimizer_.controls();
  result.iterations = outcome.iterations;
  result.status = PlanningStatus::ok;
  result.trajectory = as_trajectory(controls, options_.model_dt, problem);
  result.command = reachable_twist(controls.at(problem.command_lead / options_.model_dt), problem.twist,
                                   problem.limits, problem.command_lead);
  show_candidates(problem, result);
  if (options_.check_motion) {
    const Safety safety = safety_of(result.trajectory, problem, driving());
    evade(problem, driving(), safety, result);
  }
  optimizer_.controls().shift(problem.control_period / options_.model_dt);
  return result;
}

void MppiPlanner::show_candidates(const PlanningProblem& problem, PlanningResult& result) const {
  const Eigen::ArrayXd& costs = optimizer_.costs();
  result.candidates.push_back({"mean", (optimizer_.weights() * costs).sum(), true, result.trajectory});
  std::vector<Eigen::Index> order(static_cast<std::size_t>(costs.size()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto shown = std::min(order.size(), kShownSamples);
  const auto end_of_shown = order.begin() + static_cast<std::ptrdiff_t>(shown);
  std::partial_sort(order.begin(), end_of_shown, order.end(), [&](Eigen::Index a, Eigen::Index b) {
    return costs[a] != costs[b] ? costs[a] < costs[b] : a < b;
  });
  for (std::size_t i = 0; i < shown; ++i) {
    result.candidates.push_back(
        {"sample " + std::to_string(i + 1), costs[order[i]], false,
         as_trajectory(optimizer_.samples(), order[i], kShownStep, options_.model_dt, problem)});
  }
}

BW_PLANNER(MppiPlanner, MppiOptions, "mppi")

}  // namespace bw::mppi
