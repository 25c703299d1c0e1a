#include "components/local_planner/dwa/admissible_samples.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/dwa/goal_speed.hpp"
#include "components/local_planner/dwa/velocity_window.hpp"

namespace bw::dwa {
namespace {

constexpr double kClearanceCap = 3.0;       // [m]: (3.1) and D8
constexpr double kTeachingSampleCap = 2.0;  // [m] in common copies of the MATLAB sample
constexpr double kNoCloser = 0.001;         // [m] by which an arc inside the margin may come closer

// Travel until rest.
double stopping_distance(double v, const PlanningProblem& problem, const DwaOptions& options) {
  const double held = options.hold_before_braking ? problem.control_period : 0.0;
  return std::abs(v) * held + v * v / (2.0 * problem.limits.acc_max);
}

// Fox 1997: does the rotation go on beyond a contact after this travel?
bool rotates_too_fast(const Twist2& twist, double contact, const Limits& limits) {
  if (std::isinf(contact)) return false;
  const double rotation = contact * std::abs(twist.omega / twist.v);
  return twist.omega * twist.omega > 2.0 * rotation * limits.alpha_max;
}

VelocityWindow window_of(const PlanningProblem& problem, const DwaOptions& options) {
  return velocity_window(problem.twist, problem.limits, speed_towards_end(problem, options.arc_to_goal, 0.0),
                         problem.command_lead);
}

// What surrounds the robot in this cycle.
struct Surroundings {
  ClearanceField frozen;    // everything where it is now
  ClearanceField standing;  // what the roll-out's gap treats as standing
  double margin = 0.0;      // gap that counts as contact [m]
  double travel = 0.0;      // the longest that is looked at [m]
};

Surroundings surroundings_of(const PlanningProblem& problem, const Interval& speeds,
                             const DwaOptions& options) {
  const double fastest = std::max(std::abs(speeds.low), std::abs(speeds.high));
  const double travel = std::max(fastest * options.sim_time, stopping_distance(fastest, problem, options));
  const double reach = travel + std::max(gap_cap(options), kContactMargin);
  const Vector2 robot = problem.pose.position();
  const double radius = problem.footprint.radius;
  ClearanceField frozen(problem.obstacles, problem.movers, robot, radius, reach);
  ClearanceField standing =
      options.predict_movers ? ClearanceField(problem.obstacles, {}, robot, radius, reach) : frozen;
  double margin = kContactMargin;
  if (options.leave_margin) margin = std::clamp(frozen.at(robot) - kNoCloser, 0.0, margin);
  return {std::move(frozen), std::move(standing), margin, travel};
}

bool stops_in_time(const Sample& sample, const Surroundings& around, const PlanningProblem& problem,
                   const DwaOptions& options) {
  const Twist2& twist = sample.arc.twist;
  const double stopping = stopping_distance(twist.v, problem, options);
  if (options.teaching_sample) {
    return stopping <= std::max(around.frozen.at(sample.arc.at(sample.horizon).position()), 0.0);
  }
  const double asked = options.limit_turn_rate ? around.travel : stopping;
  const double contact = contact_distance(sample.arc, around.frozen, around.margin, asked);
  if (stopping > contact) return false;
  return !options.limit_turn_rate || !rotates_too_fast(twist, contact, problem.limits);
}

double gap_of(const Sample& sample, const Surroundings& around, const PlanningProblem& problem,
              const DwaOptions& options) {
  if (options.teaching_sample) return around.frozen.at(sample.arc.at(sample.horizon).position());
  const double gap = smallest_gap(sample.arc, around.standing, sample.horizon, kGapStep);
  if (!options.predict_movers) return gap;
  return std::min(
      gap, smallest_gap(sample.arc, problem.movers, problem.footprint.radius, sample.horizon, kGapStep));
}

}  // namespace

double gap_cap(const DwaOptions& options) {
  return options.teaching_sample ? kTeachingSampleCap : kClearanceCap;
}

std::vector<Sample> admissible_samples(const PlanningProblem& problem, const Vector2& aim,
                                       const DwaOptions& options) {
  const VelocityWindow window = window_of(problem, options);
  const Surroundings around = surroundings_of(problem, window.v, options);
  const double to_aim = (aim - problem.pose.position()).norm();
  std::vector<Sample> samples;
  for (const Twist2& twist :
       velocity_samples(window, problem.twist, options.v_samples, options.omega_samples)) {
    Sample sample{{problem.pose, twist}, options.sim_time};
    // A roll-out beyond the goal would reward circling it.
    const double speed = std::abs(twist.v);
    if (speed * sample.horizon > to_aim) sample.horizon = to_aim / speed;
    if (!stops_in_time(sample, around, problem, options)) continue;
    sample.gap = std::clamp(gap_of(sample, around, problem, options), 0.0, gap_cap(options));
    samples.push_back(sample);
  }
  return samples;
}

}  // namespace bw::dwa
