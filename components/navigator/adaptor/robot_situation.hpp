// Where the robot is and how it moves, by the localization or as Nav2's servers go by it; and whether a hand
// or the base keeps it from going on.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/bool.hpp>

#include "components/messages/base_stop_source.hpp"
#include "components/navigator/goal_messages.hpp"
#include "components/navigator/navigator_parameters.hpp"
#include "runtime/component.hpp"

namespace bw {

class RobotSituation {
 public:
  void listen(Setup& setup, const NavigatorParameters& parameters,
              std::shared_ptr<const TransformTree> transforms);

  /// Without a pose when it is older than PlanningInputs::kTransformTolerance, or not finite.
  Situation at(const Tick& tick) const;
  /// What a robot without a pose is told to wait for.
  std::string source() const { return by_tf_ ? "tf and odom" : "odometry/filtered"; }

 private:
  std::optional<Pose2> pose(Time now) const;

  bool by_tf_ = false;
  std::string map_frame_;
  std::string base_frame_;
  std::shared_ptr<const TransformTree> transforms_;
  Latest<nav_msgs::msg::Odometry> odometry_;
  Latest<std_msgs::msg::Bool> override_;
  BaseStopSource base_;
};

}  // namespace bw
