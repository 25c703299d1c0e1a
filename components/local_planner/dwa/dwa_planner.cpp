#include "components/local_planner/dwa/dwa_planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <numeric>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/dwa/carrot.hpp"
#include "components/local_planner/dwa/velocity_window.hpp"
#include "components/local_planner/evasion.hpp"
#include "components/local_planner/problem_check.hpp"

namespace bw::dwa {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kTeachingSampleCap = 2.0;  // [m] cap of `dist` in common copies of the MATLAB sample
constexpr double kLeaveGoalFactor =
    2.0;  // of xy_goal_tolerance: pushed out so far, a robot that had arrived drives again
constexpr double kNoCloser = 0.001;  // [m] by which an arc inside the margin may come closer

PlanningResult stop(const PlanningProblem& problem, PlanningStatus status, std::string reason) {
  PlanningResult result;
  result.status = status;
  result.reason = std::move(reason);
  result.command = stop_twist(problem.twist, problem.limits, problem.command_lead);
  return result;
}

double bearing(const Vector2& from, const Vector2& to) {
  return std::atan2(to.y() - from.y(), to.x() - from.x());
}

// Can the robot brake, and if asked also end its turn, within this travel?
bool stops_within(double travel, const Twist2& twist, const Limits& limits, bool also_turn) {
  if (twist.v * twist.v > 2.0 * travel * limits.acc_max) return false;
  if (!also_turn || twist.v == 0.0 || std::isinf(travel)) return true;
  const double turn = travel * std::abs(twist.omega / twist.v);
  return twist.omega * twist.omega <= 2.0 * turn * limits.alpha_max;
}

std::string label_of(const Twist2& twist) {
  char text[48];
  std::snprintf(text, sizeof text, "v %.2f w %.2f", twist.v, twist.omega);
  return text;
}

std::vector<TrajectoryPoint> rolled_out(const Arc& arc, double horizon, double step) {
  std::vector<TrajectoryPoint> trajectory;
  const int steps = std::max(1, static_cast<int>(std::ceil(horizon / step - 1e-9)));
  for (int i = 0; i <= steps; ++i) {
    const double time = std::min(i * step, horizon);
    trajectory.push_back({time, arc.at(time), arc.twist});
  }
  return trajectory;
}

}  // namespace

PlanningResult DwaPlanner::plan(const PlanningProblem& problem) {
  if (const std::string fault = fault_of(problem); !fault.empty()) {
    return stop(problem, PlanningStatus::bad_input, fault);
  }
  if (problem.plan.empty()) return stop(problem, PlanningStatus::no_plan, "the plan is empty");
  const double to_goal = (problem.plan.back().position() - problem.pose.position()).norm();
  arrived_ =
      problem.goal_is_final && to_goal <= options_.xy_goal_tolerance * (arrived_ ? kLeaveGoalFactor : 1.0);
  if (arrived_) return arrive(problem);

  const Vector2 aim = carrot(problem.plan, problem.pose.position(), options_.carrot_distance);
  std::optional<hrvo::Advice> advice;
  if (edwa_) advice = hrvo::advise(problem, aim, edwa_->hrvo);

  const std::vector<Sample> samples = admissible(problem, aim);
  PlanningResult result;
  result.iterations = 1;
  if (samples.empty()) {
    evade(problem, result);
  } else {
    const double cap = options_.profile == "sample" ? kTeachingSampleCap : options_.clearance_cap;
    const std::vector<double> scores =
        objective(score(samples, problem, aim, advice),
                  {options_.heading_weight, options_.clearance_weight, options_.velocity_weight},
                  normalisation_of(options_.profile), {cap, problem.limits.v_max});
    show(samples, scores, result);
  }
  if (advice) {
    result.velocity_cones = std::move(advice->cones);
    result.velocity_wanted = advice->velocity;
  }
  return result;
}

PlanningResult DwaPlanner::arrive(const PlanningProblem& problem) const {
  const double error = wrap_angle(problem.plan.back().theta - problem.pose.theta);
  Twist2 wanted;
  if (std::abs(error) > options_.yaw_goal_tolerance) {
    const double rate = std::sqrt(2.0 * 0.5 * problem.limits.alpha_max * std::abs(error));
    wanted.omega = std::copysign(std::min(rate, problem.limits.omega_max), error);
  }
  PlanningResult result;
  result.status = PlanningStatus::ok;
  result.command = reachable_twist(wanted, problem.twist, problem.limits, problem.command_lead);
  result.trajectory = {{0.0, problem.pose, problem.twist}};
  return result;
}

std::vector<DwaPlanner::Sample> DwaPlanner::admissible(const PlanningProblem& problem,
                                                       const Vector2& aim) const {
  const Limits& limits = problem.limits;
  const Vector2 robot = problem.pose.position();
  const double to_goal = (problem.plan.back().position() - robot).norm();
  const double v_cap = problem.goal_is_final ? std::sqrt(2.0 * limits.acc_max * to_goal) : limits.v_max;
  const VelocityWindow window = velocity_window(problem.twist, limits, v_cap, problem.command_lead);

  const bool teaching_sample = options_.profile == "sample";
  const double cap = teaching_sample ? kTeachingSampleCap : options_.clearance_cap;
  const double fastest = std::max(std::abs(window.v.low), std::abs(window.v.high));
  const double travel = std::max(fastest * options_.sim_time, fastest * fastest / limits.acc_max);
  const ClearanceField frozen(problem.obstacles, problem.movers, robot, problem.footprint.radius,
                              travel + std::max(cap, options_.contact_margin));
  const ClearanceField standing(problem.obstacles, {}, robot, problem.footprint.radius, travel + cap);
  const double gap_now = frozen.at(robot);
  const double margin = options_.leave_margin ? std::clamp(gap_now - kNoCloser, 0.0, options_.contact_margin)
                                              : options_.contact_margin;

  std::vector<Sample> samples;
  for (const Twist2& twist : velocity_samples(window, problem.twist, static_cast<int>(options_.v_samples),
                                              static_cast<int>(options_.omega_samples))) {
    Sample sample{{problem.pose, twist}, options_.sim_time, cap};
    // A roll-out beyond the goal would reward circling it.
    if (const double v = std::abs(twist.v); v * sample.horizon > (aim - robot).norm()) {
      sample.horizon = (aim - robot).norm() / v;
    }
    if (teaching_sample) {
      sample.gap = frozen.at(sample.arc.at(sample.horizon).position());
      if (!stops_within(std::max(sample.gap, 0.0), twist, limits, false)) continue;
    } else {
      const double braking_travel = twist.v * twist.v / (2.0 * limits.acc_max);
      const double reach = options_.limit_turn_rate ? travel : braking_travel;
      const double free_travel = contact_distance(sample.arc, frozen, margin, reach);
      if (!stops_within(free_travel, twist, limits, options_.limit_turn_rate)) continue;
      const double step = options_.sim_granularity;
      sample.gap =
          smallest_gap(sample.arc, options_.predict_movers ? standing : frozen, sample.horizon, step);
      if (options_.predict_movers) {
        sample.gap = std::min(sample.gap, smallest_gap(sample.arc, problem.movers, problem.footprint.radius,
                                                       sample.horizon, step));
      }
    }
    sample.gap = std::clamp(sample.gap, 0.0, cap);
    samples.push_back(sample);
  }
  return samples;
}

ScoreColumns DwaPlanner::score(const std::vector<Sample>& samples, const PlanningProblem& problem,
                               const Vector2& aim, const std::optional<hrvo::Advice>& advice) const {
  const double hrvo_speed = advice ? advice->velocity.norm() : 0.0;
  const bool has_direction = advice && hrvo_speed >= edwa_->options.min_hrvo_speed;
  const std::string source = has_direction ? edwa_->options.heading : "goal";
  const double theta_hrvo = has_direction ? bearing({0.0, 0.0}, advice->velocity) : 0.0;

  ScoreColumns columns;
  for (const Sample& sample : samples) {
    const Twist2& twist = sample.arc.twist;
    const Pose2 end = sample.arc.at(sample.horizon);
    double error = 0.0;
    if (source == "hrvo") {
      const double time = std::min(edwa_->options.heading_time, sample.horizon);
      error = wrap_angle(theta_hrvo - (problem.pose.theta + twist.omega * time));
    } else if ((aim - end.position()).norm() > options_.xy_goal_tolerance) {
      // Nearer than that the bearing says nothing: the arc leads to the goal.
      error = wrap_angle(bearing(end.position(), aim) - (source == "goal" ? end.theta : theta_hrvo));
    }
    columns.heading.push_back(kPi - std::abs(error));
    columns.clearance.push_back(sample.gap);
    columns.velocity.push_back(advice && edwa_->options.hrvo_speed
                                   ? problem.limits.v_max - std::abs(twist.v - hrvo_speed)
                                   : std::abs(twist.v));
  }
  return columns;
}

void DwaPlanner::show(const std::vector<Sample>& samples, const std::vector<double>& scores,
                      PlanningResult& result) const {
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const std::size_t shown = std::min(samples.size(), static_cast<std::size_t>(options_.shown_candidates));
  std::partial_sort(
      order.begin(), order.begin() + static_cast<std::ptrdiff_t>(shown), order.end(),
      [&](std::size_t a, std::size_t b) { return scores[a] != scores[b] ? scores[a] > scores[b] : a < b; });
  for (std::size_t i = 0; i < shown; ++i) {
    const Sample& sample = samples[order[i]];
    result.candidates.push_back({label_of(sample.arc.twist), -scores[order[i]], i == 0,
                                 rolled_out(sample.arc, sample.horizon, options_.sim_granularity)});
  }
  result.status = PlanningStatus::ok;
  result.command = samples[order[0]].arc.twist;
  result.trajectory = result.candidates.front().trajectory;
}

void DwaPlanner::evade(const PlanningProblem& problem, PlanningResult& result) const {
  result.status = PlanningStatus::infeasible;
  result.reason = "no velocity is admissible";
  result.command = stop_twist(problem.twist, problem.limits, problem.command_lead);
  if (options_.evasion_horizon <= 0.0) return;
  EvasiveMove move =
      best_evasive_move(problem, problem.plan.back().position(),
                        {options_.evasion_horizon, problem.command_lead, 0.0, options_.contact_margin});
  if (move.trajectory[1].twist == result.command) return;
  result.status = PlanningStatus::ok;
  result.reason = "evading";
  result.command = move.trajectory[1].twist;
  result.trajectory = std::move(move.trajectory);
}

}  // namespace bw::dwa
