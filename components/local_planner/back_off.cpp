#include "components/local_planner/back_off.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/command_limits.hpp"
#include "components/local_planner/problem_check.hpp"
#include "components/model/footprint_outline.hpp"
#include "components/model/footprint_touch.hpp"
#include "components/model/mover_weight.hpp"

namespace bw {
namespace {

constexpr double kFarAway = 10.0;  // [m]

/// How far a disc of `radius` can move along -x of the robot until it touches a point at `p_B` (base_link).
double free_distance(const Vector2& p_B, double radius) {
  if (p_B.x() > 0.0 || std::abs(p_B.y()) >= radius) return kFarAway;
  return std::max(0.0, -p_B.x() - std::sqrt(radius * radius - p_B.y() * p_B.y()));
}

/// The same for a footprint with a disc of `radius` around the point.
double free_distance(const Vector2& p_B, const Footprint& footprint, double radius) {
  if (!footprint.is_polygon()) return free_distance(p_B, footprint.radius + radius);
  return std::min(kFarAway, first_touch({-1.0, 0.0}, padded(footprint, radius).polygon, p_B).distance);
}

double free_distance_behind(const PlanningProblem& problem) {
  const Pose2 X_BO = inverse(problem.pose);
  const Footprint& footprint = problem.footprint;
  double distance = kFarAway;
  for (const Vector2& p : problem.obstacles.points)
    distance = std::min(distance, free_distance(X_BO * p, footprint, 0.0));
  for (const Disc& disc : problem.obstacles.discs)
    distance = std::min(distance, free_distance(X_BO * disc.center, footprint, disc.radius));
  for (const Segment& segment : problem.obstacles.segments) {
    const double length = (segment.b - segment.a).norm();
    const int steps = 1 + static_cast<int>(length / 0.05);
    for (int i = 0; i <= steps; ++i) {
      const Vector2 at = segment.a + (segment.b - segment.a) * i / steps;
      distance = std::min(distance, free_distance(X_BO * at, footprint, 0.0));
    }
  }
  for (const Mover& mover : problem.movers) {
    if (!is_confirmed(mover)) continue;
    for (const double t : {0.0, 0.5, 1.0})
      distance = std::min(distance, free_distance(X_BO * mover.position_at(t), footprint, mover.radius));
  }
  return distance;
}

}  // namespace

PlanningResult back_off(const PlanningProblem& problem, double period, double margin) {
  PlanningResult result;
  result.command = stop_twist(problem.twist, problem.limits, period);
  if (std::string fault = fault_of(problem); !fault.empty()) {
    result.status = PlanningStatus::bad_input;
    result.reason = std::move(fault);
    return result;
  }
  const double distance = free_distance_behind(problem) - margin;
  if (distance <= 0.0 || problem.limits.v_back_max <= 0.0) {
    result.status = PlanningStatus::infeasible;
    result.reason = distance <= 0.0 ? "something is close behind" : "the base does not drive backwards";
    return result;
  }
  const double speed =
      std::min(problem.limits.v_back_max, std::sqrt(2.0 * problem.limits.acc_max * distance));
  result.status = PlanningStatus::ok;
  result.command = reachable_twist({-speed, 0.0}, problem.twist, problem.limits, period);
  return result;
}

}  // namespace bw
