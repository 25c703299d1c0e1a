#include "components/local_planner/dwa/stuck_recovery.hpp"

#include <algorithm>
#include <cmath>

#include "components/local_planner/back_off.hpp"
#include "components/local_planner/dwa/led_plan.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/mover_weight.hpp"

namespace bw::dwa {
namespace {

constexpr double kPatience = 2.0;       // [s]
constexpr double kDistance = 0.3;       // [m]
constexpr double kMarginBehind = 0.05;  // [m]
constexpr double kNearPeople = 2.0;     // [m] within which it waits for who walks

bool stands(const Twist2& twist) { return std::abs(twist.v) < 0.02 && std::abs(twist.omega) < 0.05; }

bool somebody_walks_nearby(const PlanningProblem& problem) {
  return std::any_of(problem.movers.begin(), problem.movers.end(), [&](const Mover& m) {
    return is_confirmed(m) && m.velocity.norm() >= kStanding &&
           (m.position - problem.pose.position()).norm() < kNearPeople;
  });
}

}  // namespace

bool StuckRecovery::is_stuck(const PlanningProblem& problem, const PlanningResult& result) {
  if (!stands(problem.twist) || !stands(result.command) || somebody_walks_nearby(problem)) {
    standing_since_.reset();
    return false;
  }
  if (!standing_since_ || problem.now < *standing_since_) standing_since_ = problem.now;
  return (problem.now - *standing_since_).to_seconds() >= kPatience;
}

void StuckRecovery::apply(const PlanningProblem& problem, PlanningResult& result) {
  const Vector2 here = problem.pose.position();
  if (!backing_from_ && is_stuck(problem, result)) backing_from_ = here;
  if (!backing_from_) return;
  const PlanningResult back = back_off(problem, problem.command_lead, kMarginBehind);
  if ((here - *backing_from_).norm() >= kDistance || back.status != PlanningStatus::ok) {
    forget();
    return;
  }
  for (Candidate& candidate : result.candidates) candidate.chosen = false;
  result.status = PlanningStatus::ok;
  result.reason = "backing off";
  result.command = back.command;
  const double lead = problem.command_lead;
  result.trajectory = {{0.0, problem.pose, problem.twist},
                       {lead, advance_exact(problem.pose, back.command, lead), back.command}};
}

}  // namespace bw::dwa
