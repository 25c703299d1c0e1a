#include "components/navigator/adaptor/goal_frames.hpp"

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "components/messages/geometry.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

void GoalFrames::listen(Setup& setup, std::shared_ptr<const TransformTree> transforms) {
  map_frame_ = setup.frame("map");
  transforms_ = std::move(transforms);
}

PlacedGoal GoalFrames::place(const geometry_msgs::msg::PoseStamped& pose, Time now) const {
  if (const std::string fault = fault_of(pose.pose()); !fault.empty())
    return {{}, {GoalFault::unplaced, "the goal is no pose: " + fault}};
  const Pose2 X_FG = from_pose(normalised(pose.pose()));
  const std::string& frame = pose.header().frame_id();
  if (frame == map_frame_) return {{X_FG, {}}, {}};
  constexpr double kLongest = 1.0;  // [s] that transforms may lag behind, or a client's clock run ahead
  const Time stamp = from_stamp(pose.header().stamp());
  std::optional<Pose2> X_MF = transforms_->lookup_planar(map_frame_, frame, stamp);
  const std::optional<Pose2> X_MF_newest = transforms_->lookup_planar(map_frame_, frame);
  if (!X_MF_newest)
    return {{X_FG, {}},
            {GoalFault::unplaced,
             "the goal is in frame '" + frame + "', which is not known in '" + map_frame_ + "'"}};
  const double age = (now - stamp).to_seconds();
  if (!X_MF && std::abs(age) <= kLongest) X_MF = X_MF_newest;
  if (!X_MF)
    return {
        {X_FG, {}},
        {GoalFault::unplaced,
         fmt::format(
             "the goal is in frame '{}' as it is {:.1f} s {}: its place in '{}' at that time is not known",
             frame, std::abs(age), age < 0.0 ? "ahead" : "ago", map_frame_)}};
  return {{*X_MF * X_FG, {}}, {}};
}

PlacedGoal GoalFrames::place(const std::vector<geometry_msgs::msg::PoseStamped>& poses, Time now) const {
  if (poses.empty()) return {{}, {GoalFault::no_poses, "the list of poses is empty"}};
  PlacedGoal all;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    PlacedGoal one = place(poses[i], now);
    if (!one.is_good()) {
      one.problem.reason = fmt::format("pose {} of {}: {}", i, poses.size(), one.problem.reason);
      return one;
    }
    if (i > 0) all.goal.via.push_back(std::exchange(all.goal.X_MG, one.goal.X_MG));
    if (i == 0) all.goal.X_MG = one.goal.X_MG;
  }
  return all;
}

}  // namespace bw
