#include "components/local_planner/evasion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "components/local_planner/footprint_check.hpp"
#include "components/model/differential_drive.hpp"

namespace bw {
namespace {

constexpr std::array kSpeedShares{1.0, 0.75, 0.5, 0.25, 0.0};  // of v_max; v_back_max is added
constexpr std::array kTurnShares{0.0, 0.33, -0.33, 0.67, -0.67, 1.0, -1.0};
constexpr double kGapWeight = 10.0;  // metres of progress that a metre of gap is worth below `enough`

double approach(double now, double target, double speeding_up, double slowing_down, double period) {
  const bool slower = std::abs(target) < std::abs(now) || target * now < 0.0;
  const double change = (slower ? slowing_down : speeding_up) * period;
  return std::clamp(target, now - change, now + change);
}

std::vector<TrajectoryPoint> simulate(const PlanningProblem& problem, const Twist2& target, double horizon,
                                      double period) {
  const Limits& limits = problem.limits;
  std::vector<TrajectoryPoint> trajectory{{0.0, problem.pose, problem.twist}};
  for (double time = period; time < horizon + period / 2.0; time += period) {
    const TrajectoryPoint& last = trajectory.back();
    const Twist2 twist{approach(last.twist.v, target.v, limits.acc_max, limits.stop_deceleration, period),
                       approach(last.twist.omega, target.omega, limits.alpha_max, limits.alpha_max, period)};
    trajectory.push_back({time, advance_exact(last.pose, twist, period), twist});
  }
  return trajectory;
}

}  // namespace

EvasiveMove best_evasive_move(const PlanningProblem& problem, const Vector2& goal, double horizon,
                              double period, double enough) {
  EvasiveMove best;
  double best_score = -std::numeric_limits<double>::infinity();
  const auto consider = [&](double v, double omega) {
    std::vector<TrajectoryPoint> trajectory = simulate(problem, {v, omega}, horizon, period);
    const double gap =
        gap_along(trajectory, horizon, 0.1, problem.footprint, problem.obstacles, problem.movers);
    const double score =
        kGapWeight * std::min(gap, enough) - (trajectory.back().pose.position() - goal).norm();
    if (score > best_score) {
      best_score = score;
      best = {gap, std::move(trajectory)};
    }
  };
  for (const double turn : kTurnShares) {
    for (const double speed : kSpeedShares)
      consider(speed * problem.limits.v_max, turn * problem.limits.omega_max);
    if (problem.limits.v_back_max > 0.0)
      consider(-problem.limits.v_back_max, turn * problem.limits.omega_max);
  }
  return best;
}

}  // namespace bw
