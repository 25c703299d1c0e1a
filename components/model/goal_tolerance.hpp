// When a goal counts as reached. There is one figure in a graph, the navigator's; its requests and reports
// carry it, and who plans towards the goal or judges the drive derives its own from that.
#pragma once

namespace bw {

/// Within both the robot is there.
struct GoalTolerance {
  double xy = 0.2;   ///< distance between base_link and the goal [m]
  double yaw = 0.3;  ///< heading error, either way [rad]

  friend bool operator==(const GoalTolerance&, const GoalTolerance&) = default;
};

/// Where a planner ends its drive, unless told otherwise: half of the way in, so that coming to rest, and
/// what localization and odometry disagree by, stay inside; a third of the heading, which rotating in place
/// reaches anyway.
constexpr GoalTolerance inside(const GoalTolerance& reached) { return {reached.xy / 2.0, reached.yaw / 3.0}; }

/// Where a judge who knows the truth still agrees that the robot is there [m]: the robot knows its position
/// by about 0.1 m.
constexpr double judged_xy(const GoalTolerance& reached) { return reached.xy + 0.1; }

}  // namespace bw
