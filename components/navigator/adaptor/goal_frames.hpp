// Poses of goals, in whatever frame and of whatever time, as poses in map.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <geometry_msgs/msg/pose_stamped.hpp>

#include "components/navigator/goal_messages.hpp"
#include "runtime/component.hpp"

namespace bw {

/// Where a message says to go, or why nobody can go there.
struct PlacedGoal {
  NavigationGoal goal;  ///< the poses before the last are its via poses
  GoalProblem problem;  ///< without a fault: the goal is good
  bool is_good() const { return problem.fault == GoalFault::none; }
};

class GoalFrames {
 public:
  void listen(Setup& setup, std::shared_ptr<const TransformTree> transforms);

  /// In a frame that moves in map the stamp says when: 0 now; what lies out of the transforms at hand by more
  /// than a second is refused. In map it says nothing.
  PlacedGoal place(const geometry_msgs::msg::PoseStamped& pose, Time now) const;
  /// The last is the goal, those before it its via poses. None at all is a problem too.
  PlacedGoal place(const std::vector<geometry_msgs::msg::PoseStamped>& poses, Time now) const;

  const std::string& map_frame() const { return map_frame_; }

 private:
  std::string map_frame_;
  std::shared_ptr<const TransformTree> transforms_;
};

}  // namespace bw
