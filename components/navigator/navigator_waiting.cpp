// What keeps a goal waiting from outside: a pose that is not known, a hand, a base that stands.
#include <string>

#include "components/navigator/navigator.hpp"

namespace bw {

void Navigator::advance_lost(const Situation& situation) {
  if (situation.X_MB) return begin_planning(situation);
  if (phase_ != Phase::lost) {
    order(FollowMode::stop, situation.now);
    plan_id_ = 0;
    phase_ = Phase::lost;
    phase_since_ = situation.now;
    reason_ = "waiting for a pose in the map";
  } else if (older_than(phase_since_, options_.lost_patience, situation.now)) {
    abort({GoalFault::unplaced, "the robot does not know where it is"}, situation);
  }
}

void Navigator::claim(const Situation& situation) {
  if (situation.two_sigma <= judged_xy(options_.tolerance()))
    return finish(GoalStatus::succeeded, "reached", situation);
  const GoalProblem problem{GoalFault::unplaced,
                            "the robot stands at the goal, if it is where it thinks: it does not know"};
  reason_ = problem.reason;
  if (older_than(*within_since_, options_.lost_patience, situation.now)) abort(problem, situation);
}

void Navigator::advance_overridden(const Situation& situation) {
  if (!situation.is_overridden) return begin_planning(situation);
  if (phase_ == Phase::overridden) return;
  order(FollowMode::stop, situation.now);
  plan_id_ = 0;
  phase_ = Phase::overridden;
  phase_since_ = situation.now;
  set_status(status_, "interrupted by a hand: goes on after release_stop", situation);
}

void Navigator::see_base(const Situation& situation) {
  if (situation.base_stop == base_stop_) return;
  base_stop_ = situation.base_stop;
  progress_.reset();
  stuck_since_.reset();
  set_status(status_, waiting_for_base(), situation);
}

std::string Navigator::waiting_for_base() const {
  return base_stop_ ? "waiting: " + in_words(*base_stop_) : std::string();
}

GoalProblem Navigator::hindrance(const Situation& situation) const {
  const bool is_waiting = has_goal() && phase_ != Phase::canceling;
  if (is_waiting || !situation.base_stop) return {};
  return {GoalFault::base_stands, in_words(*situation.base_stop)};
}

}  // namespace bw
