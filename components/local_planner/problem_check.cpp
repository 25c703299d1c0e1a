#include "components/local_planner/problem_check.hpp"

#include <algorithm>
#include <cmath>

namespace bw {
namespace {

constexpr double kLargest = 1e6;  // [m], [m/s], [rad]; beyond it squares lose the digits that planning needs
constexpr double kShortestPeriod = 5e-3;  // [s]; motions simulated in such steps stay short
constexpr double kLongestPeriod = 10.0;   // [s]
constexpr double kEnclosing = 1e-6;       // [m] that rounding may leave a corner outside

bool sane(double value) { return std::abs(value) <= kLargest; }  // false for NaN
bool sane(const Vector2& p) { return sane(p.x()) && sane(p.y()); }
bool sane(const Pose2& p) { return sane(p.x) && sane(p.y) && sane(p.theta); }
bool positive(double value) { return value > 0.0 && value <= kLargest; }
bool size(double value) { return value >= 0.0 && value <= kLargest; }
bool period(double value) { return value >= kShortestPeriod && value <= kLongestPeriod; }

// Positions of neighbouring predictions make a velocity.
bool sane_velocities(const Mover& m) {
  double time = 0.0;
  Vector2 position = m.position;
  for (const PredictedPosition& next : m.predictions) {
    if (next.time <= time) continue;
    if (!sane(Vector2((next.position - position) / (next.time - time)))) return false;
    time = next.time;
    position = next.position;
  }
  return true;
}

bool sane(const Mover& m) {
  return sane(m.position) && sane(m.velocity) && size(m.radius) && m.confidence >= 0.0 &&
         m.confidence <= 1.0 &&
         std::all_of(m.predictions.begin(), m.predictions.end(),
                     [](const PredictedPosition& p) {
                       return sane(p.time) && sane(p.position) && p.covariance.allFinite();
                     }) &&
         sane_velocities(m);
}

bool sane(const Limits& l) {
  return positive(l.v_max) && size(l.v_back_max) && positive(l.omega_max) && positive(l.acc_max) &&
         positive(l.alpha_max) && positive(l.jerk_max) && positive(l.stop_deceleration);
}

}  // namespace

std::string fault_of(const PlanningProblem& problem) {
  if (!sane(problem.pose)) return "the robot pose is not finite";
  if (!sane(problem.twist.v) || !sane(problem.twist.omega)) return "the robot velocity is not finite";
  if (!sane(problem.limits)) return "a motion limit is not a positive number";
  if (!period(problem.control_period)) return "the control period is not between 5 ms and 10 s";
  if (!period(problem.command_lead)) return "the command lead is not between 5 ms and 10 s";
  if (!size(problem.footprint.radius)) return "the footprint radius is not a positive number";
  const auto fine = [](const auto& list) {
    return std::all_of(list.begin(), list.end(), [](const auto& item) { return sane(item); });
  };
  if (!fine(problem.footprint.polygon)) return "a footprint corner is not finite";
  for (const Vector2& corner : problem.footprint.polygon) {
    if (corner.norm() > problem.footprint.radius + kEnclosing)
      return "a footprint corner is outside its radius";
  }
  if (!fine(problem.plan)) return "a pose of the plan is not finite";
  if (!fine(problem.obstacles.points)) return "an obstacle point is not finite";
  if (!std::all_of(problem.obstacles.discs.begin(), problem.obstacles.discs.end(),
                   [](const Disc& d) { return sane(d.center) && size(d.radius); })) {
    return "an obstacle disc is not finite or has a negative radius";
  }
  if (!std::all_of(problem.obstacles.segments.begin(), problem.obstacles.segments.end(),
                   [](const Segment& s) { return sane(s.a) && sane(s.b); })) {
    return "an obstacle segment is not finite";
  }
  if (!fine(problem.movers))
    return "a mover is not finite, faster than any, has a negative radius, or a confidence outside of 0 to 1";
  return {};
}

}  // namespace bw
