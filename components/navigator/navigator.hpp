// The goal state machine: one goal at a time, from acceptance to an honest end. Events in, orders out.
//
//   idle -> planning -> following -> (standing within tolerance) succeeded
//              ^   |        |  blocked, failed, silent or without progress
//              |   v        v
//              +-- waiting, backing_off          ... max_recoveries in a row without progress: aborted
//
// A newer goal preempts: the older one ends `aborted`, and its path is followed until the first plan of the
// newer one. After cancel() the goal is `canceling` until the robot stands, then `canceled`. Without a pose
// the robot stops, and the goal is aborted after lost_patience; so is one that it stands at without knowing it
// within what a judge allows. A goal may have poses to drive through: each
// is passed when the robot was near it in its turn, and plans lead through those that are left.
//
// A hand that drives meanwhile (Situation::is_overridden) stops the goal, which waits for as long as that
// lasts: it neither fails nor goes on. While the base stands (Situation::base_stop) a goal in hand waits
// likewise, but the local planner goes on to command, so that the base knows and says that it will drive on.
//
// Answers and reports count only when they carry the id of the newest order. After every event call step();
// it is also called at a steady rate, since silence is an event too.
#pragma once

#include <string>
#include <string_view>

#include "components/model/progress_checker.hpp"
#include "components/navigator/drive_checks.hpp"
#include "components/navigator/goal_messages.hpp"
#include "components/navigator/navigator_options.hpp"

namespace bw {

class Navigator {
 public:
  explicit Navigator(const NavigatorOptions& options) : options_(options) {}

  /// Holds from the next event on; the goal in hand goes on.
  void set_options(const NavigatorOptions& options) { options_ = options; }

  /// A new goal; preempts the one in hand. Returns its id. A goal that is not finite is aborted at once and
  /// preempts nothing.
  std::uint64_t accept(const NavigationGoal& goal, const Situation& situation);
  /// Reports a goal that cannot be taken (another frame, say) as aborted; the one in hand goes on.
  std::uint64_t refuse(const Pose2& X_MG, const GoalProblem& problem);
  /// Why a goal that somebody gives now should be refused: the base stands, and no goal waits for it whose
  /// place this one takes.
  GoalProblem hindrance(const Situation& situation) const;
  void cancel(const Situation& situation);
  void on_plan(const PlanAnswer& answer, const Situation& situation);
  void on_follow(const FollowReport& report, const Situation& situation);

  /// Advances to `situation.now` and returns all that is to be sent since the last call.
  NavigatorActions step(const Situation& situation);

  bool has_goal() const { return phase_ != Phase::idle; }
  /// Of the goal in hand, or of the last one.
  std::uint64_t goal_id() const { return goal_id_; }
  /// The goal in hand, or how the last one ended.
  GoalReport report(const Situation& situation) const;

 private:
  enum class Cure { wait, wait_then_back_off, back_off_then_wait };
  enum class Phase { idle, planning, following, waiting, backing_off, lost, overridden, canceling };

  /// Times of the past move along with a clock that goes back.
  void see(Time now);
  void advance(const Situation& situation);
  void see_base(const Situation& situation);
  std::string waiting_for_base() const;
  void advance_following(const Situation& situation);
  /// Where the robot stands within the tolerances, as far as it knows.
  void claim(const Situation& situation);
  void advance_recovery(const Situation& situation);
  void advance_lost(const Situation& situation);
  void advance_overridden(const Situation& situation);
  void begin_planning(const Situation& situation);
  void request_plan(Time now);
  void order(FollowMode mode, Time now, std::vector<Pose2> path = {});
  void plan_failed(const PlanAnswer& answer, const Situation& situation);
  void recover(const GoalProblem& problem, const Situation& situation, Cure cure = Cure::wait_then_back_off);
  void abort(const GoalProblem& problem, const Situation& situation);
  void finish(GoalStatus status, const std::string& reason, const Situation& situation);
  void forget_passed(const Vector2& position);
  void set_status(GoalStatus status, const std::string& reason, const Situation& situation);
  bool older_than(Time since, double seconds, Time now) const { return (now - since).to_seconds() > seconds; }

  NavigatorOptions options_;
  NavigatorActions actions_;
  Phase phase_ = Phase::idle;

  std::uint64_t goal_id_ = 0;
  std::uint64_t last_goal_id_ = 0;  ///< given out, refused ones included
  Pose2 X_MG_;
  std::vector<Pose2> via_;  ///< still to be passed
  GoalProblem problem_;     ///< of a goal that was aborted
  GoalStatus status_ = GoalStatus::accepted;
  std::string reason_;
  Time started_;
  Time now_;
  Duration navigation_time_;

  std::uint64_t last_order_id_ = 0;
  std::uint64_t plan_id_ = 0;  ///< awaited; 0: none
  Time plan_requested_;
  std::uint64_t follow_id_ = 0;
  Time follow_heard_;
  FollowMode follow_mode_ = FollowMode::stop;
  std::vector<Pose2> path_;

  ProgressChecker progress_;
  std::optional<Time> stuck_since_;
  double stuck_patience_ = 0.0;  ///< [s]
  GoalProblem stuck_;
  std::optional<BaseStop> base_stop_;  ///< as told of the goal in hand
  std::optional<Time> within_since_;
  Time phase_since_;
  std::optional<Vector2> recovery_position_;  ///< where the last recovery began
  int recoveries_in_row_ = 0;
  std::uint32_t recoveries_ = 0;
  int plan_failures_in_row_ = 0;
};

}  // namespace bw
