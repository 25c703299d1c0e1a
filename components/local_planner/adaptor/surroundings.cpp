#include "components/local_planner/adaptor/surroundings.hpp"

#include "components/local_planner/adaptor/problem_messages.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/obstacles.hpp"

namespace bw {

void Surroundings::listen(Setup& setup) {
  odom_frame_ = setup.frame("odom");
  odometry_ = setup.latest<nav_msgs::msg::Odometry>("odom", Qos::command());
  tracks_ = setup.latest<bandwagon_msgs::msg::Tracks>("tracks", Qos::command());
  obstacles_ = setup.latest<bandwagon_msgs::msg::Obstacles>("obstacles", Qos::command());
  transforms_ = setup.transforms();
}

std::optional<Pose2> Surroundings::pose_of(const std::string& frame, std::string& missing) const {
  if (frame == odom_frame_) return Pose2{};
  auto X_OF = transforms_->lookup_planar(odom_frame_, frame);
  if (!X_OF) missing = "no transform from " + frame + " to " + odom_frame_;
  return X_OF;
}

std::string Surroundings::fill(PlanningProblem& problem) const {
  if (!odometry_) return "no odometry yet";
  std::string missing;
  problem.pose = from_pose(odometry_->pose().pose());
  problem.twist = from_twist(odometry_->twist().twist());
  if (obstacles_) {
    if (const auto X_OF = pose_of(obstacles_->header().frame_id(), missing))
      problem.obstacles = to_obstacles(*obstacles_, *X_OF);
  }
  if (tracks_) {
    if (const auto X_OF = pose_of(tracks_->header().frame_id(), missing))
      problem.movers = to_movers(*tracks_, *X_OF, problem.now);
  }
  return missing;
}

std::optional<Twist2> Surroundings::twist() const {
  if (!odometry_) return std::nullopt;
  return from_twist(odometry_->twist().twist());
}

std::string Surroundings::unheard() const {
  if (!obstacles_) return "no obstacles yet";
  return tracks_ ? "" : "no people yet";
}

}  // namespace bw
