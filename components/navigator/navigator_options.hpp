// When the navigator calls a goal reached, a drive stuck and a job hopeless.
#pragma once

#include <optional>
#include <string>

#include "components/model/goal_tolerance.hpp"
#include "components/model/progress_checker.hpp"
#include "runtime/base/field.hpp"

namespace bw {

struct NavigatorOptions {
  double xy_tolerance = GoalTolerance{}.xy;
  double yaw_tolerance = GoalTolerance{}.yaw;
  /// [m/s] slower than this is standing
  static constexpr double kStoppedSpeed = 0.05;
  /// [rad/s] turning slower than this is standing
  static constexpr double kStoppedTurnRate = 0.1;
  /// [m] a pose to drive through is passed when nearer than this, as by RemovePassedGoals
  /// of Nav2's tree
  static constexpr double kViaRadius = 0.7;
  double settle_time = 1.5;
  /// [s] time between plans while driving, as RateController of Nav2's trees has it
  static constexpr double kReplanPeriod = 1.0;
  /// [s] longest wait for a plan
  static constexpr double kPlanTimeout = 2.0;
  /// [s] longest silence of the local planner
  static constexpr double kFollowTimeout = 1.0;
  /// [m] a robot that moved less within movement_time makes no progress
  static constexpr double kRequiredMovement = 0.3;
  /// [rad] a turn within movement_time that is progress too
  static constexpr double kRequiredRotation = 0.5;
  double movement_time = 10.0;
  double blocked_patience = 5.0;
  /// [s] time without a pose before giving up (set by code alone)
  double lost_patience = 10.0;
  double wait_time = 2.0;
  /// [m] how far the recovery `back off` drives back
  static constexpr double kBackOffDistance = 0.3;
  /// [s] longest time of the recovery `back off` (set by code alone)
  double back_off_time = 4.0;
  int max_recoveries = 6;
  int max_plan_failures = 3;

  template <class Visitor>
  void fields(Visitor& v) {
    v("xy_tolerance", xy_tolerance,
      {.unit = "m",
       .min = 0.01,
       .max = 5,
       .first = true,
       .doc = "distance to the goal that counts as there; the local planner stops at half of it and "
              "evaluation allows 0.1 m more, unless they say otherwise"});
    v("yaw_tolerance", yaw_tolerance,
      {.unit = "rad", .min = 0.01, .max = 3.15, .first = true, .doc = "heading error that counts as there; 3.15: any"});
    v("settle_time", settle_time,
      {.unit = "s",
       .min = 0,
       .max = 30,
       .doc = "time within the tolerances after which the robot is told to stop there"});
    v("movement_time", movement_time,
      {.unit = "s", .min = 0.5, .max = 600, .doc = "time without progress before a recovery"});
    v("blocked_patience", blocked_patience,
      {.unit = "s", .min = 0, .max = 600, .first = true, .doc = "time blocked before a recovery; raise it in crowds"});
    v("wait_time", wait_time,
      {.unit = "s", .min = 0, .max = 60, .doc = "how long the recovery `wait` lasts; raise it in crowds"});
    v("max_recoveries", max_recoveries,
      {.min = 0, .max = 1000, .doc = "recoveries in a row without progress before giving up"});
    v("max_plan_failures", max_plan_failures,
      {.min = 1, .max = 1000, .doc = "answers in a row that the goal cannot be reached before giving up"});
  }

  GoalTolerance tolerance() const { return {xy_tolerance, yaw_tolerance}; }
  ProgressLimits progress() const { return {kRequiredMovement, kRequiredRotation, movement_time}; }

  std::optional<std::string> violated_rule() const {
    if (blocked_patience > movement_time) return "blocked_patience must not exceed movement_time";
    return std::nullopt;
  }
};

}  // namespace bw
