// What the local planner tells of a control cycle: the command, and what people and other components want to
// know of it.
#include <string>
#include <utility>
#include <vector>

#include "components/local_planner/adaptor/follow_messages.hpp"
#include "components/local_planner/adaptor/local_planner_component.hpp"
#include "components/local_planner/adaptor/planner_markers.hpp"
#include "components/messages/geometry.hpp"

namespace bw {
namespace {

/// Each pose has the stamp of when the robot is to be there.
nav_msgs::msg::Path to_timed_path(const std::string& frame, Time now,
                                  const std::vector<TrajectoryPoint>& trajectory) {
  nav_msgs::msg::Path path;
  path.header(make_header(frame, now));
  path.poses().reserve(trajectory.size());
  for (const TrajectoryPoint& point : trajectory) {
    geometry_msgs::msg::PoseStamped stamped;
    stamped.header(make_header(frame, now + Duration::seconds(point.time)));
    stamped.pose(to_pose(point.pose));
    path.poses().push_back(std::move(stamped));
  }
  return path;
}

}  // namespace

void LocalPlannerComponent::publish(const Tick& tick, const PlanningProblem& problem,
                                    const PlanningResult& result) {
  const bool idle = task_.mode == bandwagon_msgs::msg::FollowRequest_Constants::STOP;
  std_msgs::msg::Bool brake_hard;
  brake_hard.data(!idle && result.brakes_hard);
  if (brake_hard.data() || was_hard_)
    brake_hard_.publish(brake_hard);  // first, so that the command is reached so
  was_hard_ = brake_hard.data();
  if (!(idle && at_rest_)) command_.publish(result.command, tick.now);
  commanded_ = result.command.v;
  at_rest_ = idle && (at_rest_ || result.command == Twist2{});
  publish_status(tick, result, idle);
  watch_->report(result, idle, *diagnostics_);
  tell_doubts();
  if (idle) return publish_cycle(tick, result, idle);
  if (result.status != last_status_ && result.status != PlanningStatus::ok) log_.warn("{}", result.reason);
  last_status_ = result.status;
  if (trajectory_.has_readers())
    trajectory_.publish(to_timed_path(inputs_.odom_frame(), tick.now, result.trajectory));
  if (markers_.has_readers()) markers_.publish(to_markers(problem, result, inputs_.odom_frame()));
  publish_cycle(tick, result, idle);
  watch_->end(result);
}

void LocalPlannerComponent::tell_doubts() {
  const std::size_t count = inputs_.tracks_without_confidence();
  if (!doubt_.is_news(count == 0 ? ""
                                 : "tracks with a confidence that is not from 0 to 1 are taken for people"))
    return;
  diagnostics_->set_value("tracks_without_confidence", count == 0 ? "none" : "yes");
  if (doubt_) log_.warn("{}", doubt_.what());
}

void LocalPlannerComponent::publish_status(const Tick& tick, const PlanningResult& result, bool idle) {
  bandwagon_msgs::msg::FollowStatus status = to_follow_status(result, idle);
  if (!request_lost_.empty()) {
    status.status(bandwagon_msgs::msg::FollowStatus_Constants::FAILED);
    status.reason(request_lost_);
  }
  status.header(make_header(inputs_.odom_frame(), tick.now));
  status.id(request_id_);
  status.distance_to_goal(path_.distance_to_goal());
  status_.publish(status);
}

void LocalPlannerComponent::publish_cycle(const Tick& tick, const PlanningResult& result, bool idle) {
  bandwagon_msgs::msg::PlannerCycle cycle = watch_->message(result, idle);
  cycle.header(make_header(inputs_.odom_frame(), tick.now));
  cycle.planner(planner_label(parameters_.algorithm));
  cycle_.publish(cycle);
}

}  // namespace bw
