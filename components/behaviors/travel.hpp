// The one motion that spin, drive_on_heading and backup are: from rest, along one axis, to rest on the
// target.
//
//   rest      whatever the robot still does when the goal comes is braked first; distance counts from there
//   rate      the largest from which the distance that is left is enough, with the command held for
//             `command_lead` and then braked (safety::speed_within), reached within the acceleration
//   ahead     the motion to come is simulated with that same rule, and must be free (look_ahead.hpp)
//   arrival   within a tolerance and at rest. What has passed its target stops; nothing turns back
#pragma once

#include <optional>

#include "components/behaviors/behavior.hpp"
#include "components/behaviors/behavior_options.hpp"

namespace bw {

enum class TravelAxis { rotation, straight };

struct TravelGoal {
  TravelAxis axis = TravelAxis::straight;
  double target = 0.0;      ///< [rad] or [m]; the sign is the direction
  double top_rate = 0.0;    ///< [rad/s] or [m/s], more than 0
  Duration time_allowance;  ///< from acceptance; 0 or less: none
  bool is_watched = true;   ///< the look-ahead may end it
};

class Travel final : public Behavior {
 public:
  Travel(const TravelGoal& goal, const BehaviorOptions& options, Time accepted);

  BehaviorStep step(const BehaviorSituation& situation) override;

  static constexpr double kTolerance = 0.005;  ///< [rad] or [m] to the target

 private:
  void measure(const Pose2& X_OB);
  bool is_stuck(Duration age, const Pose2& X_OB);
  double top_rate(const Limits& limits) const;
  double acceleration(const Limits& limits) const;
  double next_rate(double left, double rate, const PlanningProblem& problem) const;
  Twist2 along(double rate) const;
  bool is_blocked(const PlanningProblem& problem) const;

  TravelGoal goal_;
  BehaviorOptions options_;
  double sign_;
  GoalAge age_;
  std::optional<Pose2> X_OS_;  ///< where the motion started
  Pose2 X_OB_before_;
  double traveled_ = 0.0;  ///< towards the target
  double rate_ = 0.0;      ///< commanded last, towards the target
  Pose2 X_OB_moved_;       ///< where the robot was when it was last seen to move
  std::optional<Duration> moved_;
};

}  // namespace bw
