// The neighbours of the navigator for tests in lock-step: planners, and a robot on a line.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/plan_request.hpp>
#include <bandwagon_msgs/msg/plan_result.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <rcl_interfaces/msg/log.hpp>

#include "components/messages/geometry.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {

using bandwagon_msgs::msg::BaseState;
using bandwagon_msgs::msg::FollowRequest;
using bandwagon_msgs::msg::FollowStatus;
using bandwagon_msgs::msg::NavigationStatus;
using bandwagon_msgs::msg::PlanRequest;
using bandwagon_msgs::msg::PlanResult;
namespace BaseState_Constants = bandwagon_msgs::msg::BaseState_Constants;
namespace FollowRequest_Constants = bandwagon_msgs::msg::FollowRequest_Constants;
namespace FollowStatus_Constants = bandwagon_msgs::msg::FollowStatus_Constants;
namespace NavigationStatus_Constants = bandwagon_msgs::msg::NavigationStatus_Constants;
namespace PlanResult_Constants = bandwagon_msgs::msg::PlanResult_Constants;

/// Planners and a robot that runs along the x axis at 1 m/s while it is told to follow.
struct World {
  double wall = 1e9;                                     ///< no goal beyond this x can be reached
  bool is_lost = false;                                  ///< no odometry
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the pose
  std::optional<BaseState>
      base;  ///< nothing: a base that does not tell; one that does obeys when it drives or waits
  double x = 0.0;
  double goal_x = 0.0;
  std::uint8_t mode = FollowRequest_Constants::STOP;
  std::uint64_t follow_id = 0;
  int plans = 0;
  int stops = 0;                        ///< requests to stand
  std::vector<std::size_t> via_counts;  ///< of the plan requests
  FollowRequest last_follow;            ///< the last request
  std::vector<NavigationStatus> statuses;
  std::vector<std::string> log;  ///< of the navigator

  void configure(bw::Setup& setup) {
    setup.input<PlanRequest>("plan_request", Qos::standard(),
                             [this, out = setup.output<PlanResult>("plan_result")](const PlanRequest& request,
                                                                                   const Tick& tick) mutable {
                               ++plans;
                               via_counts.push_back(request.via_poses().size());
                               PlanResult result;
                               result.id(request.id());
                               const Pose2 goal = from_pose(request.goal().pose());
                               if (goal.x > wall) {
                                 result.status(PlanResult_Constants::GOAL_BLOCKED);
                                 result.reason("the goal lies in a wall");
                                 result.error_code(206);
                               } else {
                                 goal_x = goal.x;
                                 result.path(to_path("map", tick.now, {{x, 0, 0}, goal}));
                               }
                               out.publish(result);
                             });
    setup.input<FollowRequest>("follow_request", Qos::standard(),
                               [this](const FollowRequest& message, const Tick&) {
                                 last_follow = message;
                                 stops += message.mode() == FollowRequest_Constants::STOP ? 1 : 0;
                                 mode = message.mode();
                                 follow_id = message.id();
                               });
    setup.input<NavigationStatus>("navigation_status", Qos::standard(50),
                                  [this](const auto& status, const Tick&) { statuses.push_back(status); });
    setup.input<rcl_interfaces::msg::Log>(
        "/rosout", Qos::rosout(),
        [this](const auto& line, const Tick&) {
          if (line.name() == "navigator") log.push_back(line.msg());
        },
        Need::optional);
    setup.every(Duration::milliseconds(50), "move",
                [this, odometry = setup.output<nav_msgs::msg::Odometry>("odometry/filtered"),
                 states = setup.output<BaseState>("base_state"),
                 follow = setup.output<FollowStatus>("follow_status")](const Tick&) mutable {
                  if (base) states.publish(*base);
                  const bool stands = base && base->state() > BaseState_Constants::WAITING;
                  const double left = goal_x - x;
                  const double v = mode == FollowRequest_Constants::FOLLOW && !stands && std::abs(left) > 1e-9
                                       ? std::copysign(1.0, left)
                                       : 0.0;
                  x = std::abs(left) < 0.05 && v != 0.0 ? goal_x : x + 0.05 * v;
                  nav_msgs::msg::Odometry message;
                  message.pose().pose(to_pose({x, 0, 0}));
                  set_planar_covariance(message.pose().covariance(), covariance);
                  message.twist().twist().linear().x(v);
                  if (!is_lost) odometry.publish(message);
                  FollowStatus status;
                  status.id(follow_id);
                  status.status(FollowStatus_Constants::FOLLOWING);
                  follow.publish(status);
                });
  }
};

inline BaseState base_state(std::uint8_t state, bool is_latched = false, const std::string& reason = "") {
  BaseState message;
  message.state(state);
  message.is_latched(is_latched);
  message.reason(reason);
  return message;
}

inline geometry_msgs::msg::PoseStamped goal(double x, const std::string& frame = "map") {
  geometry_msgs::msg::PoseStamped message;
  message.header().frame_id(frame);
  message.pose(to_pose({x, 0, 0}));
  return message;
}

}  // namespace bw
