#include "components/behaviors/travel.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "components/behaviors/look_ahead.hpp"
#include "components/local_planner/problem_check.hpp"
#include "components/model/differential_drive.hpp"
#include "components/safety/free_distance.hpp"

namespace bw {
namespace {

constexpr double kMoved = 0.02;     // [m], [rad] that show that the robot moves
constexpr double kPatience = 10.0;  // [s] without that; then a goal without an allowance of its own fails
constexpr double kSlowest = 0.02;   // [m/s] but for the last step, unless the goal asks for it
constexpr double kMargin = 0.02;    // [m] around the footprint that the look-ahead asks for

/// With what explains it, where something does.
std::string with(std::string text, const std::string& reason) {
  return reason.empty() ? text : text + "; " + reason;
}

BehaviorStep stopped(BehaviorStep step) {
  step.command = Twist2{};
  return step;
}

}  // namespace

Travel::Travel(const TravelGoal& goal, const BehaviorOptions& options, Time accepted)
    : goal_(goal), options_(options), sign_(goal.target < 0.0 ? -1.0 : 1.0), age_(accepted) {}

BehaviorStep Travel::step(const BehaviorSituation& situation) {
  const PlanningProblem& problem = situation.problem;
  const Duration age = age_.at(problem.now);
  const auto end = [&](BehaviorError error, std::string text) {
    BehaviorStep step = failed(error, std::move(text));
    step.traveled = traveled_ * (goal_.axis == TravelAxis::rotation ? sign_ : 1.0);
    return stopped(step);
  };
  if (!situation.missing.empty()) return end(BehaviorError::tf_error, situation.missing);
  const std::string base = situation.base_stop ? in_words(*situation.base_stop) : "";
  if (situation.base_stop && situation.base_stop->is_latched) return end(BehaviorError::unknown, base);
  if (goal_.is_watched && !situation.unseen.empty()) return end(BehaviorError::tf_error, situation.unseen);
  if (std::string fault = fault_of(problem); !fault.empty())
    return end(BehaviorError::tf_error, std::move(fault));
  measure(problem.pose);
  if (goal_.time_allowance > Duration{} && age > goal_.time_allowance)
    return end(BehaviorError::timeout,
               with("the time allowance was over before the target was reached", base));
  if (is_stuck(age, problem.pose)) return end(BehaviorError::unknown, with("the robot does not move", base));
  BehaviorStep step{.traveled = traveled_ * (goal_.axis == TravelAxis::rotation ? sign_ : 1.0)};
  const bool standing = is_at_rest(problem.twist);
  if (!X_OS_ && !standing) return stopped(step);
  if (!X_OS_) X_OS_ = X_OB_before_ = problem.pose;
  const double left = std::abs(goal_.target) - traveled_;
  rate_ = next_rate(left, rate_, problem);
  if (left <= kTolerance) {
    if (standing) step.state = BehaviorStep::State::succeeded;
    return stopped(step);
  }
  if (goal_.is_watched && is_blocked(problem))
    return end(BehaviorError::collision_ahead, "something is in the way");
  step.command = along(rate_);
  return step;
}

void Travel::measure(const Pose2& X_OB) {
  if (!X_OS_) return;
  if (goal_.axis == TravelAxis::rotation) {
    traveled_ += sign_ * wrap_angle(X_OB.theta - X_OB_before_.theta);
  } else {
    traveled_ = sign_ * (inverse(*X_OS_) * X_OB.position()).x();
  }
  X_OB_before_ = X_OB;
}

bool Travel::is_stuck(Duration age, const Pose2& X_OB) {
  const bool moves = !moved_ || (X_OB.position() - X_OB_moved_.position()).norm() > kMoved ||
                     std::abs(wrap_angle(X_OB.theta - X_OB_moved_.theta)) > kMoved;
  if (moves) {
    moved_ = age;
    X_OB_moved_ = X_OB;
  }
  return goal_.time_allowance <= Duration{} && age - *moved_ > Duration::seconds(kPatience);
}

// Of a short distance the middle is driven at one rate for as long as the jerk limit needs to turn
// acceleration into braking.
double Travel::top_rate(const Limits& limits) const {
  if (goal_.axis == TravelAxis::rotation) return std::min(goal_.top_rate, limits.omega_max);
  const double turnover = 2.0 * acceleration(limits) / limits.jerk_max;
  const double for_distance = safety::speed_within(
      std::abs(goal_.target),
      {.reaction_time = options_.command_lead + turnover, .deceleration = acceleration(limits) / 2.0});
  return std::min({goal_.top_rate, sign_ > 0.0 ? limits.v_max : limits.v_back_max, for_distance});
}

double Travel::acceleration(const Limits& limits) const {
  return goal_.axis == TravelAxis::rotation ? std::min(options_.rotational_acc_lim, limits.alpha_max)
                                            : limits.acc_max;
}

double Travel::next_rate(double left, double rate, const PlanningProblem& problem) const {
  if (left <= kTolerance) return 0.0;
  const double acceleration_limit = acceleration(problem.limits);
  const double step = acceleration_limit * problem.control_period;
  const double top = top_rate(problem.limits);
  const double slowest = goal_.axis == TravelAxis::rotation ? options_.min_rotational_vel : kSlowest;
  const double onset =
      goal_.axis == TravelAxis::rotation ? 0.0 : acceleration_limit / (2.0 * problem.limits.jerk_max);
  const double braking = safety::speed_within(
      left, {.reaction_time = options_.command_lead + onset, .deceleration = acceleration_limit});
  const double wanted = std::max(braking, std::min(slowest, left / problem.control_period));
  return std::clamp(std::min(wanted, top), std::max(0.0, rate - step), rate + step);
}

Twist2 Travel::along(double rate) const {
  return goal_.axis == TravelAxis::rotation ? Twist2{0.0, sign_ * rate} : Twist2{sign_ * rate, 0.0};
}

bool Travel::is_blocked(const PlanningProblem& problem) const {
  const double period = problem.control_period;
  const double rate_now =
      std::max(0.0, sign_ * (goal_.axis == TravelAxis::rotation ? problem.twist.omega : problem.twist.v));
  const double braking = acceleration(problem.limits) * period;
  const double to_rest = rate_now / acceleration(problem.limits) + options_.command_lead + period;
  const double horizon = std::max(options_.simulate_ahead_time, to_rest);
  std::vector<TrajectoryPoint> motion, stop;
  Pose2 X_motion = problem.pose, X_stop = problem.pose;
  double left = std::abs(goal_.target) - traveled_;
  double rate = rate_, stop_rate = rate_now;
  for (double time = 0.0; time < horizon + period; time += period) {
    motion.push_back({time, X_motion, along(rate)});
    stop.push_back({time, X_stop, along(stop_rate)});
    X_motion = advance_exact(X_motion, along(rate), period);
    X_stop = advance_exact(X_stop, along(stop_rate), period);
    left -= rate * period;
    rate = next_rate(left, rate, problem);
    stop_rate = std::max(0.0, stop_rate - braking);
  }
  return brings_contact(motion, stop, kMargin, problem);
}

}  // namespace bw
