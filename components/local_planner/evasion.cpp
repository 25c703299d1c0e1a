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
constexpr std::array kTurnTimes{0.5, 1.0, 1.5};  // [s]
constexpr double kGapWeight = 10.0;   // metres of progress that a metre of gap is worth below `enough_gap`
constexpr double kTestStep = 0.1;     // [m] between footprint tests
constexpr double kWorthMoving = 0.2;  // [s] of later contact for which a robot that could stop moves instead

double approach(double now, double target, double speeding_up, double slowing_down, double period) {
  if (target * now < 0.0) target = 0.0;  // first to rest: only braking may use the deceleration of a stop
  const double change = (std::abs(target) < std::abs(now) ? slowing_down : speeding_up) * period;
  return std::clamp(target, now - change, now + change);
}

// Velocities to aim at: `first` until `switch_time` [s], `then` after it.
struct Intent {
  Twist2 first;
  double switch_time = 0.0;
  Twist2 then;
};

std::vector<TrajectoryPoint> simulate(const PlanningProblem& problem, const Intent& intent, double horizon,
                                      double period) {
  const Limits& limits = problem.limits;
  std::vector<TrajectoryPoint> trajectory{{0.0, problem.pose, problem.twist}};
  const int steps = std::max(1, static_cast<int>(std::lround(horizon / period)));
  for (int i = 1; i <= steps; ++i) {
    const double time = i * period;
    const TrajectoryPoint& last = trajectory.back();
    const Twist2& target = time <= intent.switch_time ? intent.first : intent.then;
    const Twist2 twist{approach(last.twist.v, target.v, limits.acc_max, limits.stop_deceleration, period),
                       approach(last.twist.omega, target.omega, limits.alpha_max, limits.alpha_max, period)};
    trajectory.push_back({time, advance_exact(last.pose, twist, period), twist});
  }
  return trajectory;
}

// Steady arcs, and turning away before driving off.
std::vector<Intent> intents(const Limits& limits) {
  std::vector<Intent> list;
  for (const double turn : kTurnShares) {
    const double omega = turn * limits.omega_max;
    for (const double speed : kSpeedShares) list.push_back({{}, 0.0, {speed * limits.v_max, omega}});
    if (limits.v_back_max > 0.0) list.push_back({{}, 0.0, {-limits.v_back_max, omega}});
  }
  for (const double switch_time : kTurnTimes) {
    for (const double v : {0.0, -limits.v_back_max}) {
      for (const double omega : {limits.omega_max, -limits.omega_max}) {
        list.push_back({{v, omega}, switch_time, {limits.v_max, 0.0}});
      }
    }
  }
  return list;
}

}  // namespace

EvasiveMove best_evasive_move(const PlanningProblem& problem, const Vector2& goal,
                              const EvasionOptions& options) {
  const auto simulated = [&](const Intent& intent) {
    EvasiveMove move;
    move.trajectory = simulate(problem, intent, options.horizon, options.period);
    const MotionGap met = gap_along(move.trajectory, options.horizon, kTestStep, options.asked_gap, problem);
    move.gap = met.gap;
    move.contact_time = met.contact_time;
    return move;
  };
  EvasiveMove best_clear;
  double best_score = -std::numeric_limits<double>::infinity();
  EvasiveMove stop = simulated({});
  // Nothing comes closer to a robot that stands: stand, instead of pacing in front of what blocks the way.
  if (stop.gap >= options.enough_gap) return stop;
  EvasiveMove latest = stop;
  for (const Intent& intent : intents(problem.limits)) {
    EvasiveMove move = simulated(intent);
    if (std::isinf(move.contact_time)) {
      const double score = kGapWeight * std::min(move.gap, options.enough_gap) -
                           (move.trajectory.back().pose.position() - goal).norm();
      if (score <= best_score) continue;
      best_score = score;
      best_clear = std::move(move);
    } else if (move.contact_time > latest.contact_time) {
      latest = std::move(move);
    }
  }
  if (!best_clear.trajectory.empty()) return best_clear;
  const double stopping_time = std::abs(latest.trajectory[1].twist.v) / problem.limits.stop_deceleration;
  const bool worth_it = latest.contact_time > stop.contact_time + kWorthMoving &&
                        latest.contact_time > options.period + stopping_time + kWorthMoving;
  return worth_it ? latest : stop;
}

}  // namespace bw
