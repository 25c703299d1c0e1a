// One drive of follow_path, judged cycle by cycle: it goes on, the robot is there, or it is hopeless. A newer
// path for the same drive renews nothing but what it changes: progress and patience go on.
#pragma once

#include <optional>
#include <string>

#include "components/local_planner/follow_path/follow_fault.hpp"
#include "components/local_planner/follow_path/follow_path_options.hpp"
#include "components/model/base_stop.hpp"
#include "components/model/planning.hpp"

namespace bw {

/// What a cycle knew and did. Poses are of base_link in odom.
struct FollowCycle {
  Time now;
  std::string missing;       ///< an input that is stale, or was never there; empty: none
  std::string unknown_pose;  ///< the transform that is not known; empty: none
  std::optional<BaseStop> base_stop = std::nullopt;  ///< nothing: it obeys, or does not tell
  Pose2 X_OB;                                        ///< of no meaning when something is missing or not known
  Pose2 X_OG;
  double distance_to_goal = 0.0;  ///< along the path [m]
  bool is_on_last_leg = true;     ///< the path does not turn back any more before the goal
  double travelled = 0.0;         ///< along the paths of this drive [m]
  Twist2 twist;
  PlanningStatus status = PlanningStatus::ok;
  std::string reason;  ///< of the planner
};

struct FollowVerdict {
  bool is_over = false;
  FollowFailure failure;  ///< fault `none` when it is over and the robot is there
};

class FollowJudge {
 public:
  /// A drive that begins where there was none.
  void begin();
  /// In every cycle of the drive.
  FollowVerdict judge(const FollowCycle& cycle, const FollowPathOptions& options);

 private:
  FollowVerdict judge_absence(const FollowCycle& cycle, const FollowPathOptions& options);
  bool makes_progress(const FollowCycle& cycle, const ProgressCheckerOptions& options);
  bool is_there(const FollowCycle& cycle, const GoalCheckerOptions& options);
  FollowVerdict judge_control(const FollowCycle& cycle, double tolerance);

  Time now_;
  struct Progress {
    Time time;
    double travelled;  ///< then [m]
  };
  std::optional<Progress> progress_;     ///< the last
  std::optional<Time> absent_since_;     ///< something needed
  std::optional<Time> within_since_;     ///< the tolerances of the goal
  std::optional<Time> no_motion_since_;  ///< the last cycle that had one
};

}  // namespace bw
