#include "components/local_planner/adaptor/problem_messages.hpp"

#include <algorithm>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "components/messages/geometry.hpp"
#include "runtime/stamps.hpp"

namespace bw {
namespace {

Eigen::Matrix2d rotated(const Eigen::Matrix2d& covariance, double angle) {
  const Eigen::Rotation2Dd R(angle);
  return R.toRotationMatrix() * covariance * R.toRotationMatrix().transpose();
}

Mover to_mover(const bandwagon_msgs::msg::Track& track, const Pose2& X_OF) {
  Mover mover;
  mover.id = track.id();
  mover.radius = track.radius();
  mover.confidence = tells_confidence(track) ? track.confidence() : 1.0;
  mover.position = X_OF * Vector2(track.position().x(), track.position().y());
  mover.velocity = rotate(X_OF, Vector2(track.velocity().x(), track.velocity().y()));
  for (const auto& p : track.predictions()) {
    Eigen::Matrix2d covariance;
    covariance << p.cov_xx(), p.cov_xy(), p.cov_xy(), p.cov_yy();
    const double time = p.time_from_start().sec() + 1e-9 * p.time_from_start().nanosec();
    mover.predictions.push_back({.time = time,
                                 .position = X_OF * Vector2(p.x(), p.y()),
                                 .covariance = rotated(covariance, X_OF.theta)});
  }
  return mover;
}

/// The mover as seen `age` seconds later, if it moved as predicted.
Mover advanced(Mover mover, double age) {
  const Vector2 position = mover.position_at(age);
  std::erase_if(mover.predictions, [&](const PredictedPosition& p) { return p.time <= age; });
  for (PredictedPosition& p : mover.predictions) p.time -= age;
  mover.position = position;
  return mover;
}

}  // namespace

bool tells_confidence(const bandwagon_msgs::msg::Track& track) {
  return track.confidence() >= 0.0 && track.confidence() <= 1.0;  // false for NaN
}

std::vector<Mover> to_movers(const bandwagon_msgs::msg::Tracks& message, const Pose2& X_OF, Time now) {
  const double age = (now - from_stamp(message.header().stamp())).to_seconds();
  std::vector<Mover> movers;
  for (const auto& track : message.tracks())
    movers.push_back(advanced(to_mover(track, X_OF), std::max(0.0, age)));
  return movers;
}

GoalTolerance goal_tolerance_of(const bandwagon_msgs::msg::FollowRequest& request) {
  GoalTolerance tolerance;
  if (request.xy_tolerance() > 0.0) tolerance.xy = request.xy_tolerance();
  if (request.yaw_tolerance() > 0.0) tolerance.yaw = request.yaw_tolerance();
  return tolerance;
}

std::string tolerance_complaint(const GoalTolerance& goal, const DrivingOptions& own) {
  if (own.xy_goal_tolerance <= goal.xy && own.yaw_goal_tolerance <= goal.yaw) return {};
  const GoalTolerance used = arrival_tolerance({.goal_tolerance = goal}, own);
  return fmt::format(
      "xy_goal_tolerance {:g} m and yaw_goal_tolerance {:g} rad must not exceed what the navigator calls reached, {:g} m "
      "and {:g} rad: {:g} m and {:g} rad are used",
      own.xy_goal_tolerance, own.yaw_goal_tolerance, goal.xy, goal.yaw, used.xy, used.yaw);
}

bandwagon_msgs::msg::FollowStatus to_follow_status(const PlanningResult& result, bool idle) {
  namespace follow = bandwagon_msgs::msg::FollowStatus_Constants;
  bandwagon_msgs::msg::FollowStatus status;
  if (idle) {
    status.status(follow::IDLE);
  } else if (result.status == PlanningStatus::ok) {
    status.status(follow::FOLLOWING);
  } else {
    status.status(result.status == PlanningStatus::infeasible ? follow::BLOCKED : follow::FAILED);
  }
  status.reason(idle ? "" : result.reason);
  status.command(to_twist_message(result.command));
  return status;
}

}  // namespace bw
