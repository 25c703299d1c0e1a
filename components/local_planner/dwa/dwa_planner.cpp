#include "components/local_planner/dwa/dwa_planner.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "components/local_planner/carrot.hpp"
#include "components/local_planner/dwa/sample_label.hpp"
#include "components/local_planner/dwa/sample_score.hpp"
#include "components/local_planner/dwa/stopping_motion.hpp"

namespace bw::dwa {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<TrajectoryPoint> rolled_out(const Sample& sample) {
  std::vector<TrajectoryPoint> trajectory;
  const int steps = std::max(1, static_cast<int>(std::ceil(sample.horizon / kGapStep - 1e-9)));
  for (int i = 0; i <= steps; ++i) {
    const double time = std::min(i * kGapStep, sample.horizon);
    trajectory.push_back({time, sample.arc.at(time), sample.arc.twist});
  }
  return trajectory;
}

ScoreColumns columns_of(const std::vector<Sample>& samples, const Guidance& guidance) {
  ScoreColumns columns;
  for (const Sample& sample : samples) {
    columns.heading.push_back(kPi - std::abs(guidance.heading_error(sample)));
    columns.clearance.push_back(sample.gap);
    columns.velocity.push_back(guidance.velocity_score(sample));
  }
  return columns;
}

}  // namespace

PlanningResult DwaPlanner::drive(const PlanningProblem& problem) {
  const Vector2 aim = carrot(problem.plan, problem.pose.position(), options_.carrot_distance);
  const Guidance guidance = guide_(problem, aim);
  const std::vector<Sample> samples = admissible_samples(problem, aim, options_);
  PlanningResult result;
  result.iterations = 1;
  const std::vector<double> scores =
      objective(columns_of(samples, guidance), options_.weights, options_.normalisation,
                {gap_cap(options_), problem.limits.v_max});
  choose(samples, scores, problem, result);
  // An arc is left in time, so walls at its end do not count; people on it do.
  Safety safety;
  if (!result.trajectory.empty()) safety = {true, safety_of(result.trajectory, problem, driving()).comfort};
  evade(problem, driving(), safety, result);
  if (guidance.advice) {
    result.velocity_cones = guidance.advice->cones;
    result.velocity_wanted = guidance.advice->velocity;
  }
  return result;
}

void DwaPlanner::choose(const std::vector<Sample>& samples, const std::vector<double>& scores,
                        const PlanningProblem& problem, PlanningResult& result) const {
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    if (scores[a] != scores[b]) return scores[a] > scores[b];
    // Of equals the straightest, so that a mirrored scene is driven mirrored.
    const double turn_rate_a = std::abs(samples[a].arc.twist.omega);
    const double turn_rate_b = std::abs(samples[b].arc.twist.omega);
    return turn_rate_a != turn_rate_b ? turn_rate_a < turn_rate_b : a < b;
  });
  for (const std::size_t index : order) {
    const Sample& sample = samples[index];
    const bool chosen = result.trajectory.empty() && can_stop_among_movers(sample, problem);
    if (result.candidates.size() < options_.shown_candidates || chosen) {
      result.candidates.push_back({label_of(sample.arc.twist), -scores[index], chosen, rolled_out(sample)});
    }
    if (chosen) {
      result.status = PlanningStatus::ok;
      result.command = sample.arc.twist;
      result.trajectory = result.candidates.back().trajectory;
    }
    if (result.candidates.size() >= options_.shown_candidates && !result.trajectory.empty()) break;
  }
}

bool DwaPlanner::can_stop_among_movers(const Sample& sample, const PlanningProblem& problem) const {
  if (!options_.check_movers) return true;
  return is_free(stopping_motion(sample.arc, problem.control_period, problem.limits.acc_max), problem,
                 driving());
}

}  // namespace bw::dwa
