// What is around the robot, from messages into a planning problem: its odometry, people, obstacles, and the transforms between their
// frames and odom. Shared by all who plan or watch a motion.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/model/planning.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

class Surroundings {
 public:
  /// Topics `odom`, `tracks`, `obstacles`, /tf.
  void listen(Setup& setup);

  /// Pose, twist, obstacles and movers at problem.now, all in odom. Nothing is in the way of who has heard of nothing: ask unheard().
  /// Returns one sentence when odometry or a transform is missing.
  std::string fill(PlanningProblem& problem) const;
  /// One sentence when people or obstacles were never heard of since activation.
  std::string unheard() const;
  /// Measured last, if ever.
  std::optional<Twist2> twist() const;
  /// X_OF: a frame in odom; if it is not connected, `missing` says so.
  std::optional<Pose2> pose_of(const std::string& frame, std::string& missing) const;

 private:
  std::string odom_frame_;
  Latest<nav_msgs::msg::Odometry> odometry_;
  Latest<bandwagon_msgs::msg::Tracks> tracks_;
  Latest<bandwagon_msgs::msg::Obstacles> obstacles_;
  std::shared_ptr<const TransformTree> transforms_;
};

}  // namespace bw
