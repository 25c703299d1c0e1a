// A robot that obeys its local planner at once, and a client that sends it goals of follow_path, in
// lock-step.
#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <nav2_msgs/action/follow_path.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/nav2_results.hpp"
#include "components/model/differential_drive.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {

/// Odometry began somewhere in the map, and rotated.
inline const Pose2 kX_MO{4.0, -3.0, 2.0};

/// How one goal fared.
struct GoalStory {
  bool is_accepted = false;
  int ends = 0;  ///< terminal states
  GoalStatus status = GoalStatus::unknown;
  int code = -1;
  std::string text;
  double ended = 0.0;  ///< [s] since the start
};

/// `A`: the action in the layout of the graph.
template <class A = nav2_msgs::action::FollowPath>
class FollowPathRig {
 public:
  static constexpr double kStep = 0.02;  // [s]
  using Goal = typename A::Goal;

  // What happens.
  std::string settings;                      ///< of the planner in the graph
  std::string head;                          ///< of the graph
  std::map<int, std::function<void()>> at;   ///< by step, after the robot has moved
  bandwagon_msgs::msg::Obstacles obstacles;  ///< in map
  bool has_odometry = true;
  bandwagon_msgs::msg::BaseState base;       ///< what the base tells
  // What is seen.
  Pose2 X_MB;
  Twist2 twist;
  std::vector<std::pair<double, Twist2>> commands;  ///< [s] since the start
  std::vector<bandwagon_msgs::msg::FollowStatus> statuses;
  std::vector<typename A::Feedback> feedback;
  std::vector<GoalStory> goals;  ///< as sent
  std::string command_frame;     ///< of TwistStamped; empty: commands are Twist
  double now = 0.0;

  static Goal to_goal(const std::vector<Pose2>& path, const std::string& frame = "map") {
    Goal goal;
    goal.path(to_path(frame, Time{}, path));
    return goal;
  }
  /// A straight path through the map from `from`, a pose each 5 cm.
  static std::vector<Pose2> straight(double from, double to) {
    std::vector<Pose2> path;
    const int pieces = static_cast<int>(std::ceil(std::abs(to - from) / 0.05));
    for (int i = 0; i <= pieces; ++i) path.push_back({from + (to - from) * i / pieces, 0.0, 0.0});
    return path;
  }

  GoalId send(const Goal& goal) {
    const std::size_t index = goals.size();
    goals.emplace_back();
    return client_.send(
        goal, Duration::milliseconds(1000),
        {.on_acknowledged = [this, index](bool yes, const Tick&) { goals[index].is_accepted = yes; },
         .on_feedback = [this](const typename A::Feedback& message,
                               const Tick&) { feedback.push_back(message); },
         .on_result =
             [this, index](GoalStatus status, const typename A::Result* result, const Tick& tick) {
               GoalStory& story = goals[index];
               ++story.ends;
               story.status = status;
               story.ended = seconds_since_start(tick.now);
               if (result == nullptr) return;
               story.code = error_code_of(*result);
               story.text = error_text_of(*result);
             }});
  }
  void cancel(const GoalId& id) { client_.cancel(id); }
  /// Of the planner, by its label.
  void change(const std::string& transition) {
    lifecycle_msgs::srv::ChangeState::Request request;
    request.transition().label(transition);
    change_state_.call(request, Duration::milliseconds(100), [](const auto*, const Tick&) {});
  }
  void request(std::uint64_t id, std::uint8_t mode, const std::vector<Pose2>& path = {}) {
    bandwagon_msgs::msg::FollowRequest message;
    message.id(id);
    message.mode(mode);
    message.path(to_path("map", Time{}, path));
    request_.publish(message);
  }

  void run(double seconds) {
    run_with_script(head + "\ncomponents: {local_planner: {" + settings + "}}", seconds,
                    [this](Setup& setup) { configure(setup); });
  }

 private:
  void configure(Setup& setup) {
    const auto obey = [this](const geometry_msgs::msg::Twist& message, const Tick& tick) {
      twist = from_twist(message);
      commands.emplace_back(seconds_since_start(tick.now), twist);
    };
    if (settings.find("enable_stamped_cmd_vel: auto") == std::string::npos) {
      setup.input<geometry_msgs::msg::Twist>("cmd_vel_nav", Qos::command(), obey);
    } else {
      setup.input<geometry_msgs::msg::TwistStamped>("cmd_vel_nav", Qos::command(),
                                                    [this, obey](const auto& message, const Tick& tick) {
                                                      command_frame = message.header().frame_id();
                                                      obey(message.twist(), tick);
                                                    });
    }
    setup.input<bandwagon_msgs::msg::FollowStatus>(
        "follow_status", Qos::standard(50), [this](const auto& m, const Tick&) { statuses.push_back(m); });
    client_ = setup.action_client<A>("follow_path");
    change_state_ = setup.client<lifecycle_msgs::srv::ChangeState>("/local_planner/change_state");
    request_ = setup.output<bandwagon_msgs::msg::FollowRequest>("follow_request");
    base_ = setup.output<bandwagon_msgs::msg::BaseState>("base_state");
    odometry_ = setup.output<nav_msgs::msg::Odometry>("odom");
    obstacles_ = setup.output<bandwagon_msgs::msg::Obstacles>("obstacles");
    tracks_ = setup.output<bandwagon_msgs::msg::Tracks>("tracks");
    tf_ = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf());
    setup.every(Duration::seconds(kStep), "robot", [this](const Tick& tick) { step(tick); });
  }

  void step(const Tick& tick) {
    now = seconds_since_start(tick.now);
    X_MB = advance_exact(X_MB, twist, kStep);
    const Pose2 X_OB = inverse(kX_MO) * X_MB;
    tf2_msgs::msg::TFMessage transforms;
    transforms.transforms().push_back(to_transform("map", "odom", tick.now, kX_MO));
    transforms.transforms().push_back(to_transform("odom", "base_link", tick.now, X_OB));
    tf_.publish(transforms);
    nav_msgs::msg::Odometry odometry;
    odometry.header(make_header("odom", tick.now));
    odometry.pose().pose(to_pose(X_OB));
    odometry.twist().twist(to_twist_message(twist));
    if (has_odometry) odometry_.publish(odometry);
    base_.publish(base);
    obstacles.header(make_header("map", tick.now));
    obstacles_.publish(obstacles);
    bandwagon_msgs::msg::Tracks nobody;
    nobody.header(make_header("map", tick.now));
    tracks_.publish(nobody);
    if (const auto act = at.find(static_cast<int>(tick.sequence)); act != at.end()) act->second();
  }

  ActionClient<A> client_;
  Client<lifecycle_msgs::srv::ChangeState> change_state_;
  Output<bandwagon_msgs::msg::FollowRequest> request_;
  Output<bandwagon_msgs::msg::BaseState> base_;
  Output<nav_msgs::msg::Odometry> odometry_;
  Output<bandwagon_msgs::msg::Obstacles> obstacles_;
  Output<bandwagon_msgs::msg::Tracks> tracks_;
  Output<tf2_msgs::msg::TFMessage> tf_;
};

}  // namespace bw
