// Where a velocity leads that is reached within the limits and then held, and what the footprint meets there.
#pragma once

#include <optional>
#include <vector>

#include "components/local_planner/timed_gaps.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

struct RollOutRules {
  double horizon = 1.7;         ///< [s]
  double distance = 0.0;        ///< longest travel [m]
  double margin = 0.0;          ///< a gap below it is contact [m]
  double reach = 0.55;          ///< larger gaps are not told apart [m]
  bool predict_movers = false;  ///< movers are where they will be; else they stand where they are
};

struct RollOut {
  Twist2 twist;           ///< that is held
  Pose2 end;              ///< at the horizon, at the longest distance, after 3 rad, or before the contact
  double time = 0.0;      ///< until there [s]
  double travel = 0.0;    ///< until there [m]
  double rotation = 0.0;  ///< until there, either way [rad]
  double gap = 0.0;       ///< smallest until there [m]; at most the reach
  double gap_time = 0.0;  ///< when it is that small [s]
  bool meets = false;     ///< it ends before a contact
};

/// Roll-outs from the pose and velocity of one problem, which must outlive it. v and omega approach the
/// velocity that is held at acc_max and alpha_max. No point of the footprint moves more than 5 cm between two
/// looks.
class RollOuts {
 public:
  RollOuts(const PlanningProblem& problem, const RollOutRules& rules);
  RollOuts(const RollOuts&) = delete;
  RollOuts& operator=(const RollOuts&) = delete;

  RollOut along(const Twist2& held);
  /// Its poses until `time` [s], for people to see and to be checked: at least two.
  std::vector<TrajectoryPoint> trajectory(const Twist2& held, double time) const;
  /// Here and now [m]; at most the reach.
  double gap_now() const { return gap_now_; }
  /// What counts as contact [m]: the margin, or less where the robot is nearer already; negative where
  /// something is said to stand in it, as a post that is taken for somebody wider: it may leave.
  double margin() const { return margin_; }

 private:
  Twist2 velocity_at(const Twist2& held, double time) const;
  double gap_at(const Pose2& pose, double time);

  std::optional<PlanningProblem> frozen_;  // where nobody is predicted
  const PlanningProblem& problem_;
  RollOutRules rules_;
  TimedGaps gaps_;
  double gap_now_ = 0.0;
  double margin_ = 0.0;
};

}  // namespace bw::dwa
