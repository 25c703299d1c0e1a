#include "components/messages/planning_inputs.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "components/messages/geometry.hpp"
#include "components/messages/obstacles.hpp"
#include "components/messages/tracks.hpp"

namespace bw {

void PlanningInputs::listen(Setup& setup, const Robot& robot) {
  odom_frame_ = setup.frame("odom");
  map_frame_ = setup.frame("map");
  odometry_ = setup.latest<nav_msgs::msg::Odometry>("odom", Qos::command());
  tracks_ = setup.latest<bandwagon_msgs::msg::Tracks>("tracks", Qos::command());
  obstacles_ = setup.latest<bandwagon_msgs::msg::Obstacles>("obstacles", Qos::command());
  transforms_ = setup.transforms();
  speed_.listen(setup, robot.limits);
  footprint_.listen(setup, robot);
}

std::optional<Pose2> PlanningInputs::pose_in_odom(const std::string& frame, std::string& missing,
                                                  std::optional<Time> now) const {
  if (frame == odom_frame_) return Pose2{};
  const std::optional<Time> newest = transforms_->newest(odom_frame_, frame);
  if (!newest) {
    missing = "no transform from " + frame + " to " + odom_frame_;
    return std::nullopt;
  }
  if (now && *newest < *now - kTransformTolerance) {
    missing = fmt::format("the transform from {} to {} is older than {:g} s", frame, odom_frame_,
                          kTransformTolerance.to_seconds());
    return std::nullopt;
  }
  return transforms_->lookup_planar(odom_frame_, frame);
}

std::optional<Pose2> PlanningInputs::pose() const {
  return odometry_ ? std::optional(from_pose(odometry_->pose().pose())) : std::nullopt;
}

std::optional<Twist2> PlanningInputs::twist() const {
  return odometry_ ? std::optional(from_twist(odometry_->twist().twist())) : std::nullopt;
}

std::string PlanningInputs::unheard() const {
  if (!obstacles_) return "no obstacles yet";
  return tracks_ ? "" : "no people yet";
}

std::size_t PlanningInputs::tracks_without_confidence() const {
  if (!tracks_) return 0;
  return static_cast<std::size_t>(
      std::count_if(tracks_->tracks().begin(), tracks_->tracks().end(),
                    [](const bandwagon_msgs::msg::Track& track) { return !tells_confidence(track); }));
}

PlanningProblem PlanningInputs::problem(Time now, std::string& missing) const {
  PlanningProblem problem{.now = now, .footprint = footprint_.now(), .limits = speed_.limits()};
  if (!odometry_) {
    missing = "no odometry yet";
    return problem;
  }
  problem.pose = *pose();
  problem.twist = from_twist(odometry_->twist().twist());
  if (obstacles_) {
    if (const auto X_OF = pose_in_odom(obstacles_->header().frame_id(), missing, now))
      problem.obstacles = to_obstacles(*obstacles_, *X_OF);
  }
  if (tracks_) {
    if (const auto X_OF = pose_in_odom(tracks_->header().frame_id(), missing, now))
      problem.movers = to_movers(*tracks_, *X_OF, now);
  }
  return problem;
}

}  // namespace bw
