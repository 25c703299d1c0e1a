// What a planner of motions, or who watches one, knows of robot and surroundings, from topics. For adaptors
// only.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/messages/current_footprint.hpp"
#include "components/messages/speed_limit.hpp"
#include "components/model/planning.hpp"
#include "components/model/robot.hpp"
#include "runtime/component.hpp"
#include "runtime/transforms/transform_tree.hpp"

namespace bw {

/// Lives in the component whose setup it is given.
class PlanningInputs {
 public:
  void listen(Setup& setup, const Robot& robot);

  /// A problem without plan, goal and means. `missing` names what is needed and not there yet; without
  /// odometry the rest is not in it either.
  PlanningProblem problem(Time now, std::string& missing) const;
  /// One sentence when people or obstacles were never heard of since activation: then nothing seems to be in
  /// the way.
  std::string unheard() const;
  /// Tracks whose confidence is not from 0 to 1; they are taken for people.
  std::size_t tracks_without_confidence() const;
  /// Measured last, if ever.
  std::optional<Twist2> twist() const;
  const Limits& limits() const { return speed_.limits(); }
  /// Of base_link in odom.
  std::optional<Pose2> pose() const;
  /// The pose of `frame` in odom; otherwise `missing` says that there is none, or that at `now` it is older than
  /// kTransformTolerance.
  std::optional<Pose2> pose_in_odom(const std::string& frame, std::string& missing,
                                    std::optional<Time> now = std::nullopt) const;
  /// As long as the navigator drives without a pose: whoever published the transform may be gone.
  static constexpr Duration kTransformTolerance = Duration::milliseconds(500);
  const std::string& odom_frame() const { return odom_frame_; }
  const std::string& map_frame() const { return map_frame_; }

 private:
  CurrentFootprint footprint_;
  std::string odom_frame_;
  std::string map_frame_;
  LimitedSpeed speed_;
  Latest<nav_msgs::msg::Odometry> odometry_;
  Latest<bandwagon_msgs::msg::Tracks> tracks_;
  Latest<bandwagon_msgs::msg::Obstacles> obstacles_;
  std::shared_ptr<const TransformTree> transforms_;
};

}  // namespace bw
