#include "components/local_planner/follow_path/follow_judge.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace bw {
namespace {

constexpr double kStandingSpeed = 0.05;    // [m/s]
constexpr double kStandingTurnRate = 0.1;  // [rad/s]
constexpr double kLeftAlongPath = 1.0;  // [m] at most at the goal: a path that ends where it begins is driven

FollowVerdict failed(FollowFault fault, std::string reason) { return {true, {fault, std::move(reason)}}; }

/// Since when, the first cycle of it included.
Duration time_since(std::optional<Time>& since, Time now) {
  if (!since) since = now;
  return now - *since;
}

}  // namespace

void FollowJudge::begin() { *this = {}; }

FollowVerdict FollowJudge::judge(const FollowCycle& cycle, const FollowPathOptions& options) {
  if (cycle.now < now_) begin();  // the clock went back
  now_ = cycle.now;
  if (!cycle.missing.empty() || !cycle.unknown_pose.empty()) return judge_absence(cycle, options);
  absent_since_.reset();
  if (is_there(cycle, options.goal_checker)) return {.is_over = true, .failure = {}};
  if (cycle.base_stop && cycle.base_stop->is_latched)
    return failed(FollowFault::failed_to_make_progress, in_words(*cycle.base_stop));
  const ProgressCheckerOptions& checker = options.progress_checker;
  if (!options.progress_checker_plugins.empty() && !makes_progress(cycle, checker)) {
    std::ostringstream reason;
    reason << "no progress: less than " << checker.required_movement_radius << " m in "
           << checker.movement_time_allowance << " s";
    if (!cycle.reason.empty()) reason << "; " << cycle.reason;
    if (cycle.base_stop) reason << "; " << in_words(*cycle.base_stop);
    return failed(FollowFault::failed_to_make_progress, reason.str());
  }
  return judge_control(cycle, options.failure_tolerance);
}

// Not any movement, as in Nav2: who drives to and fro gets nowhere.
bool FollowJudge::makes_progress(const FollowCycle& cycle, const ProgressCheckerOptions& options) {
  if (!progress_ || cycle.travelled >= progress_->travelled + options.required_movement_radius)
    progress_ = Progress{cycle.now, cycle.travelled};
  return cycle.now - progress_->time <= Duration::seconds(options.movement_time_allowance);
}

FollowVerdict FollowJudge::judge_absence(const FollowCycle& cycle, const FollowPathOptions& options) {
  within_since_.reset();
  const Duration absent = time_since(absent_since_, cycle.now);
  if (absent < Duration::seconds(options.costmap_update_timeout)) return {};
  return cycle.missing.empty() ? failed(FollowFault::tf_error, cycle.unknown_pose)
                               : failed(FollowFault::controller_timed_out, cycle.missing);
}

bool FollowJudge::is_there(const FollowCycle& cycle, const GoalCheckerOptions& options) {
  const bool is_within =
      cycle.is_on_last_leg &&
      (cycle.X_OG.position() - cycle.X_OB.position()).norm() <= options.xy_goal_tolerance &&
      std::abs(wrap_angle(cycle.X_OG.theta - cycle.X_OB.theta)) <= options.yaw_goal_tolerance &&
      cycle.distance_to_goal <= std::max(kLeftAlongPath, options.xy_goal_tolerance);
  if (!is_within) {
    within_since_.reset();
    return false;
  }
  const bool is_standing =
      std::abs(cycle.twist.v) <= kStandingSpeed && std::abs(cycle.twist.omega) <= kStandingTurnRate;
  return time_since(within_since_, cycle.now) >= Duration::seconds(options.kSettleTime) || is_standing;
}

FollowVerdict FollowJudge::judge_control(const FollowCycle& cycle, double tolerance) {
  if (cycle.status == PlanningStatus::ok) {
    no_motion_since_ = cycle.now;
    return {};
  }
  if (tolerance == 0.0) return failed(FollowFault::no_valid_control, cycle.reason);
  const Duration without = time_since(no_motion_since_, cycle.now);
  if (tolerance < 0.0 || without <= Duration::seconds(tolerance)) return {};
  std::ostringstream reason;
  reason << cycle.reason << "; no way for more than " << tolerance << " s";
  return failed(FollowFault::patience_exceeded, reason.str());
}

}  // namespace bw
