// A path that is being followed: how far along it the robot has come, and the stretch that a planner works on
// now (global_planner/theory.md 7.4).
//
// Progress is a length along the path. It never falls, and rises only to positions near the last one: 3 m at
// most, and what the robot has driven since. So a path that crosses itself, comes back over itself or ends
// where it begins is followed in order.
//
// The path is cut into legs at its sharp corners (path_corners). A planner is given the leg in hand alone,
// with its end as a goal at which to stop; the next leg begins when the robot is within the tolerance of the
// corner, by a rotation in place until it faces the way on. All legs are driven forwards. Within a leg the
// stretch may be asked to end where its chord would leave the path by more than a figure: a planner that
// takes the straight path to the end of what it is given cuts no bend by more.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "components/local_planner/plan_line.hpp"
#include "components/model/goal_tolerance.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

/// What a planner is to do in this cycle, in the frame of the path.
struct PathLeg {
  std::vector<Pose2> poses;  ///< from near the robot to the local goal; empty when the path is
  bool goal_is_final =
      true;                 ///< the local goal is to be arrived at, at rest: a corner, or the end of the path
  GoalTolerance tolerance;  ///< of the local goal
  bool begins = false;      ///< another leg than in the cycle before: what was planned for that one is over
};

struct FollowLimits {
  double lookahead = 6.0;   ///< length of the stretch at most, about [m]
  GoalTolerance tolerance;  ///< of the path's end and of its corners
  double max_deviation =
      std::numeric_limits<double>::infinity();  ///< of the stretch's chord from the path [m]
};

class FollowedPath {
 public:
  /// A new path; the robot's position on it is looked for from its beginning, when the next leg is asked for:
  /// the first position from which going on along the path leads away from the robot.
  void start(std::vector<Pose2> poses);

  /// For a robot at `X_PB` in the path's frame, in every cycle.
  const PathLeg& leg(const Pose2& X_PB, const FollowLimits& limits);

  const std::vector<Pose2>& poses() const { return poses_; }

  // As of the last leg:
  /// Of the pose nearest to the robot's position on the path.
  std::size_t index() const { return index_; }
  /// To that pose, and along the path to its end [m].
  double distance_to_goal() const { return distance_to_goal_; }
  /// No sharp corner is left.
  bool is_on_last_leg() const { return corner_ == corners_.size(); }
  /// By which the distance to the goal has shrunk since the first path [m]; another path does not count.
  double travelled() const { return travelled_; }

 private:
  std::size_t leg_end() const { return is_on_last_leg() ? poses_.size() - 1 : corners_[corner_]; }
  void advance(const Vector2& robot, const FollowLimits& limits);
  /// False when no place further on, within `reach` [m], is nearer to the robot.
  bool advance_once(const Vector2& robot, double reach);
  bool pass_corner(const Vector2& robot, double tolerance);
  void measure(const Vector2& robot);
  /// Whether the robot has still to turn to the way on; then that is the leg.
  bool rotate_first(const Pose2& X_PB);
  void cut(const Vector2& robot, const FollowLimits& limits);
  /// [m] along the path, up to where a chord from the robot's position leaves it; infinity: not before `end`.
  double straight_until(double end, double max_deviation) const;
  /// The pose `along` [m] the path, with the direction in which the path comes to it.
  Pose2 pose_at(double along) const;

  std::vector<Pose2> poses_;
  std::optional<PlanLine> line_;
  std::vector<double> along_;  ///< of each pose [m]
  std::vector<std::size_t> corners_;

  double progress_ = 0.0;         ///< of the robot along the path [m]
  std::size_t corner_ = 0;        ///< the next one, of `corners_`
  bool is_rotating_ = false;      ///< at the corner before
  std::optional<Vector2> robot_;  ///< where it was in the last cycle on this path
  std::size_t index_ = 0;
  double distance_to_goal_ = 0.0;
  double travelled_ = 0.0;
  PathLeg leg_;
};

}  // namespace bw
