#include "components/navigator/navigator.hpp"

#include <algorithm>
#include <utility>

namespace bw {
namespace {

constexpr double kSoonestReplan = 0.2;      // after becoming blocked [s]
constexpr double kRecoveredDistance = 1.0;  // farther from the last recovery than this is progress [m]
constexpr double kFailedPatience = 1.0;     // a missing input often comes back [s]
constexpr double kCancelPatience = 5.0;     // for the robot to come to rest [s]

}  // namespace

void Navigator::see(Time now) {
  const Duration back = now_ - now;
  now_ = now;
  if (back <= Duration{}) return;
  for (Time* past : {&started_, &plan_requested_, &follow_heard_, &phase_since_}) *past = *past - back;
  for (std::optional<Time>* past : {&stuck_since_, &within_since_})
    if (*past) **past = **past - back;
  progress_.reset();
}

std::uint64_t Navigator::accept(const NavigationGoal& goal, const Situation& situation) {
  see(situation.now);
  if (!is_finite(goal.X_MG) || !std::ranges::all_of(goal.via, [](const Pose2& X) { return is_finite(X); }))
    return refuse({}, {GoalFault::unplaced, "the goal is not a finite pose"});
  const std::uint64_t id = ++last_goal_id_;
  std::optional<GoalReport> preempted;
  if (has_goal()) {
    preempted = report(situation);
    preempted->status = GoalStatus::aborted;
    preempted->reason = "preempted by goal " + std::to_string(id);
    preempted->fault = GoalFault::preempted;
    preempted->navigation_time = situation.now - started_;
  }
  goal_id_ = id;
  X_MG_ = goal.X_MG;
  via_ = goal.via;
  problem_ = {};
  started_ = situation.now;
  recoveries_ = 0;
  recoveries_in_row_ = 0;
  plan_failures_in_row_ = 0;
  recovery_position_.reset();
  base_stop_.reset();
  set_status(GoalStatus::accepted, "", situation);
  if (preempted)
    actions_.reports.push_back(*preempted);  // after its successor, so that nobody thinks the job is over
  begin_planning(situation);
  return id;
}

std::uint64_t Navigator::refuse(const Pose2& X_MG, const GoalProblem& problem) {
  actions_.reports.push_back({.goal_id = ++last_goal_id_,
                              .status = GoalStatus::aborted,
                              .reason = problem.reason,
                              .X_MG = X_MG,
                              .tolerance = options_.tolerance(),
                              .fault = problem.fault,
                              .error_code = problem.error_code});
  return last_goal_id_;
}

void Navigator::cancel(const Situation& situation) {
  see(situation.now);
  if (!has_goal() || phase_ == Phase::canceling) return;
  order(FollowMode::stop, situation.now);
  plan_id_ = 0;
  phase_ = Phase::canceling;
  phase_since_ = situation.now;
  set_status(GoalStatus::canceling, "canceled by request", situation);
}

void Navigator::on_plan(const PlanAnswer& answer, const Situation& situation) {
  see(situation.now);
  if (plan_id_ == 0 || answer.id != plan_id_) return;
  plan_id_ = 0;
  if (phase_ != Phase::planning && phase_ != Phase::following) return;
  if (answer.outcome == PlanOutcome::succeeded && !answer.path.empty()) {
    plan_failures_in_row_ = 0;
    if (phase_ == Phase::planning) {
      phase_ = Phase::following;
      phase_since_ = situation.now;
      progress_.reset();
      stuck_since_.reset();
      within_since_.reset();
      set_status(GoalStatus::executing, waiting_for_base(), situation);
    }
    path_ = answer.path;
    order(FollowMode::follow, situation.now, answer.path);
  } else {
    plan_failed(answer, situation);
  }
}

void Navigator::plan_failed(const PlanAnswer& answer, const Situation& situation) {
  const std::string reason =
      answer.outcome == PlanOutcome::succeeded ? "the plan is empty" : "no plan: " + answer.reason;
  if (phase_ == Phase::following)
    return;  // the path in hand is still good; a drive that gets stuck is seen elsewhere
  const GoalProblem problem{GoalFault::planner_failed, reason, answer.error_code};
  if (answer.outcome == PlanOutcome::bad_request) return abort(problem, situation);
  const bool out_of_reach =
      answer.outcome == PlanOutcome::goal_blocked || answer.outcome == PlanOutcome::disconnected;
  if (out_of_reach && ++plan_failures_in_row_ >= options_.max_plan_failures) {
    return abort(problem, situation);
  }
  recover(problem, situation,
          answer.outcome == PlanOutcome::start_blocked ? Cure::back_off_then_wait : Cure::wait);
}

void Navigator::on_follow(const FollowReport& report, const Situation& situation) {
  see(situation.now);
  if (report.id != follow_id_ || !has_goal()) return;
  follow_heard_ = situation.now;
  const bool stuck = report.state == FollowState::blocked || report.state == FollowState::failed;
  if (phase_ == Phase::backing_off && (stuck || report.state == FollowState::reached)) {
    return begin_planning(situation);
  }
  if (phase_ != Phase::following) return;
  if (!stuck) {
    stuck_since_.reset();
    return;
  }
  const bool failed = report.state == FollowState::failed;
  stuck_patience_ = failed ? kFailedPatience : options_.blocked_patience;
  stuck_ = {failed ? GoalFault::controller_failed : GoalFault::blocked,
            (failed ? "the local planner failed: " : "blocked: ") + report.reason, report.error_code};
  if (stuck_since_) return;
  stuck_since_ = situation.now;
  if (plan_id_ == 0 && older_than(plan_requested_, kSoonestReplan, situation.now))
    request_plan(situation.now);
}

NavigatorActions Navigator::step(const Situation& situation) {
  see(situation.now);
  if (has_goal()) {
    advance(situation);
    if (has_goal()) navigation_time_ = situation.now - started_;
  }
  if (plan_id_ == 0) actions_.plan.reset();  // asked for since the last call, and nobody waits for it now
  return std::exchange(actions_, {});
}

void Navigator::advance(const Situation& situation) {
  if (phase_ == Phase::canceling) {
    if (is_standing(situation.twist, options_))
      return finish(GoalStatus::canceled, "canceled by request", situation);
    if (older_than(phase_since_, kCancelPatience, situation.now)) {
      finish(GoalStatus::canceled, "canceled by request, but the robot does not come to rest", situation);
    }
    return;
  }
  if (phase_ == Phase::overridden || situation.is_overridden) return advance_overridden(situation);
  if (phase_ == Phase::lost || !situation.X_MB) return advance_lost(situation);
  see_base(situation);
  if (recovery_position_ && (situation.X_MB->position() - *recovery_position_).norm() > kRecoveredDistance) {
    recovery_position_.reset();
    recoveries_in_row_ = 0;
  }
  if (plan_id_ != 0 && older_than(plan_requested_, options_.kPlanTimeout, situation.now)) {
    plan_id_ = 0;
    if (phase_ == Phase::planning)
      return recover({GoalFault::planner_silent, "the global planner does not answer"}, situation);
  }
  if (phase_ == Phase::following) return advance_following(situation);
  if (phase_ == Phase::waiting || phase_ == Phase::backing_off) advance_recovery(situation);
}

void Navigator::advance_following(const Situation& situation) {
  const Time now = situation.now;
  forget_passed(situation.X_MB->position());
  if (via_.empty() && is_within_tolerance(*situation.X_MB, X_MG_, options_)) {
    if (!within_since_) within_since_ = now;
    if (is_standing(situation.twist, options_)) return claim(situation);
    if (follow_mode_ == FollowMode::follow && older_than(*within_since_, options_.settle_time, now)) {
      order(FollowMode::stop, now);
    }
    return;
  }
  within_since_.reset();
  if (follow_mode_ == FollowMode::stop)
    return begin_planning(situation);  // rolled out of the tolerance again

  if (!base_stop_ && !progress_.update(now, *situation.X_MB, options_.progress()))
    return recover({GoalFault::no_progress, "no progress towards the goal"}, situation);
  if (older_than(follow_heard_, options_.kFollowTimeout, now)) {
    return recover({GoalFault::controller_silent, "the local planner does not answer"}, situation);
  }
  if (!base_stop_ && stuck_since_ && older_than(*stuck_since_, stuck_patience_, now))
    return recover(stuck_, situation);
  if (plan_id_ == 0 && (now - plan_requested_).to_seconds() >= options_.kReplanPeriod) request_plan(now);
}

void Navigator::advance_recovery(const Situation& situation) {
  const double limit = phase_ == Phase::waiting ? options_.wait_time : options_.back_off_time;
  const bool moved = phase_ == Phase::backing_off && recovery_position_ &&
                     (situation.X_MB->position() - *recovery_position_).norm() >= options_.kBackOffDistance;
  if (moved || older_than(phase_since_, limit, situation.now)) begin_planning(situation);
}

void Navigator::begin_planning(const Situation& situation) {
  if (phase_ == Phase::backing_off) order(FollowMode::stop, situation.now);
  phase_ = Phase::planning;
  phase_since_ = situation.now;
  request_plan(situation.now);
}

void Navigator::request_plan(Time now) {
  plan_id_ = ++last_order_id_;
  plan_requested_ = now;
  actions_.plan = PlanOrder{plan_id_, X_MG_, via_};
}

void Navigator::order(FollowMode mode, Time now, std::vector<Pose2> path) {
  follow_id_ = ++last_order_id_;
  if (mode != follow_mode_) follow_heard_ = now;  // a path renewed each second must not excuse silence
  follow_mode_ = mode;
  actions_.follow = FollowOrder{follow_id_, mode, std::move(path), options_.tolerance()};
}

void Navigator::recover(const GoalProblem& problem, const Situation& situation, Cure cure) {
  if (recoveries_in_row_ >= options_.max_recoveries) {
    GoalProblem last = problem;
    last.reason += "; gave up after " + std::to_string(recoveries_in_row_) + " recoveries in a row";
    return abort(last, situation);
  }
  const bool odd = recoveries_in_row_ % 2 == 1;
  const bool back_off = cure == Cure::wait_then_back_off ? odd : cure == Cure::back_off_then_wait && !odd;
  ++recoveries_in_row_;
  ++recoveries_;
  plan_id_ = 0;
  recovery_position_ = situation.X_MB ? std::optional(situation.X_MB->position()) : std::nullopt;
  order(back_off ? FollowMode::back_off : FollowMode::stop, situation.now);
  phase_ = back_off ? Phase::backing_off : Phase::waiting;
  phase_since_ = situation.now;
  set_status(status_, (back_off ? "backing off: " : "waiting: ") + problem.reason, situation);
}

void Navigator::abort(const GoalProblem& problem, const Situation& situation) {
  problem_ = problem;
  finish(GoalStatus::aborted, problem.reason, situation);
}

void Navigator::forget_passed(const Vector2& position) {
  const auto first_left = std::ranges::find_if(
      via_, [&](const Pose2& X) { return (X.position() - position).norm() > options_.kViaRadius; });
  via_.erase(via_.begin(), first_left);
}

void Navigator::finish(GoalStatus status, const std::string& reason, const Situation& situation) {
  if (follow_mode_ != FollowMode::stop) order(FollowMode::stop, situation.now);
  plan_id_ = 0;
  set_status(status, reason, situation);
  phase_ = Phase::idle;
  path_.clear();
}

void Navigator::set_status(GoalStatus status, const std::string& reason, const Situation& situation) {
  status_ = status;
  reason_ = reason;
  navigation_time_ = situation.now - started_;
  actions_.reports.push_back(report(situation));
}

GoalReport Navigator::report(const Situation& situation) const {
  GoalReport report{.goal_id = goal_id_,
                    .status = status_,
                    .reason = reason_,
                    .X_MG = X_MG_,
                    .recoveries = recoveries_,
                    .navigation_time = navigation_time_,
                    .tolerance = options_.tolerance(),
                    .fault = problem_.fault,
                    .error_code = problem_.error_code,
                    .poses_remaining = via_.size() + 1,
                    .X_MB = situation.X_MB};
  if (!situation.X_MB) return report;
  const bool on_path = phase_ == Phase::following && !path_.empty();
  report.distance_remaining = on_path ? remaining_length(path_, situation.X_MB->position(), via_)
                                      : straight_length(situation.X_MB->position(), via_, X_MG_);
  report.estimated_time_remaining = time_remaining(report.distance_remaining, situation.twist);
  if (on_path) {
    const TrackingError error = tracking_error(path_, *situation.X_MB, via_);
    report.position_tracking_error = error.position;
    report.heading_tracking_error = error.heading;
  }
  return report;
}

}  // namespace bw
