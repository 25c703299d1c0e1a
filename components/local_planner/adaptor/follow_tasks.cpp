// What the local planner is asked to do, by topic and by action: the newer wins, and the other is told.
#include <cmath>
#include <utility>

#include "components/local_planner/adaptor/follow_messages.hpp"
#include "components/local_planner/adaptor/local_planner_component.hpp"
#include "components/messages/geometry.hpp"

namespace bw {

namespace mode = bandwagon_msgs::msg::FollowRequest_Constants;

void LocalPlannerComponent::offer_follow_path(Setup& setup) {
  follow_path_.offer(
      setup, parameters_.follow_path,
      {.fault_of_frame =
           [this](const std::string& frame) {
             if (frame.empty()) return std::string("the path names no frame");
             std::string missing;
             inputs_.pose_in_odom(frame, missing);
             return missing;
           },
       .drive = [this](const std::string& frame, const std::vector<Pose2>& poses) { on_path(frame, poses); },
       .stop = [this](const Tick& tick) { come_to_rest(tick); }});
}

void LocalPlannerComponent::on_request(const bandwagon_msgs::msg::FollowRequest& request) {
  request_id_ = request.id();
  request_lost_.clear();
  // To stop what somebody else has taken over is not its business.
  if (request.mode() == mode::STOP && follow_path_.is_driving()) return;
  follow_path_.give_way("a follow_request took over");
  begin({request.mode(), request.path().header().frame_id(), goal_tolerance_of(request)},
        from_path(request.path()));
}

// A plan in map stays there and moves with the localization; one in any other frame, which may move with the
// robot, is carried to odom once.
void LocalPlannerComponent::on_path(const std::string& frame, std::vector<Pose2> poses) {
  if (task_.mode != mode::STOP && !task_.is_of_action) request_lost_ = "a goal of follow_path took over";
  std::string missing;
  std::optional<Pose2> X_OF = inputs_.pose_in_odom(frame, missing);
  const bool is_kept = frame == inputs_.map_frame() || !X_OF;
  if (!is_kept) {
    for (Pose2& X : poses) X = *X_OF * X;
    X_OF = Pose2{};
  }
  begin({mode::FOLLOW, is_kept ? frame : inputs_.odom_frame(), follow_path_.tolerance(), true},
        std::move(poses));
}

// The path that is followed already, asked for once more, is gone on with: whoever repeats it does not want
// it from its beginning.
void LocalPlannerComponent::begin(FollowTask task, std::vector<Pose2> path) {
  if (task.mode != task_.mode) planner_->reset();
  const bool is_same = task.mode == task_.mode && task.frame == task_.frame && path == path_.poses();
  task_ = std::move(task);
  if (!is_same) path_.start(std::move(path));
  const std::string complaint = tolerance_complaint(task_.tolerance, parameters_.planners.driving);
  if (complaint != std::exchange(told_, complaint) && !complaint.empty()) log_.warn("{}", complaint);
  if (task_.mode != mode::STOP) at_rest_ = false;
}

void LocalPlannerComponent::come_to_rest(const Tick& tick) {
  task_ = {};
  planner_->reset();
  command_.publish({}, tick.now);
  at_rest_ = true;
}

void LocalPlannerComponent::report(const Tick& tick, const PlanningProblem& problem,
                                   const PlanningResult& result, const std::string& missing) {
  const bool is_stale = tick.health == Health::stop || !inputs_.pose();
  FollowCycle cycle{.now = tick.now,
                    .missing = is_stale ? result.reason : "",
                    .unknown_pose = is_stale ? "" : missing,
                    .base_stop = base_.at(tick.now),
                    .X_OB = problem.pose,
                    .X_OG = {},
                    .distance_to_goal = path_.distance_to_goal(),
                    .is_on_last_leg = path_.is_on_last_leg(),
                    .travelled = path_.travelled(),
                    .twist = problem.twist,
                    .status = result.status,
                    .reason = result.reason};
  if (X_OF_) cycle.X_OG = *X_OF_ * path_.poses().back();
  if (!follow_path_.goes_on(cycle, tick) || !X_OF_) return;
  const Pose2 X_FB = inverse(*X_OF_) * problem.pose;
  const PathOffset error = path_offset(path_.poses(), path_.index(), X_FB);
  const double to_path = (path_.poses()[path_.index()].position() - X_FB.position()).norm();
  PathTracking tracking{.path_index = static_cast<std::uint32_t>(path_.index()),
                        .distance_to_goal = static_cast<float>(path_.distance_to_goal()),
                        .remaining_path_length = static_cast<float>(path_.distance_to_goal() - to_path),
                        .speed = static_cast<float>(std::abs(result.command.v)),
                        .position_error = static_cast<float>(error.position),
                        .heading_error = static_cast<float>(error.heading)};
  tracking.robot_pose.header(make_header(task_.frame, tick.now));
  tracking.robot_pose.pose(to_pose(X_FB));
  follow_path_.tell(tracking);
}

}  // namespace bw
