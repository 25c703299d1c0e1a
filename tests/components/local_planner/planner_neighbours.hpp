// The neighbours of a local planner on its topics in lock-step: a script in place of robot, map and
// navigator.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/planner_cycle.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <nav2_msgs/msg/speed_limit.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <nav_msgs/msg/path.hpp>
#include <std_msgs/msg/bool.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/geometry.hpp"
#include "components/model/differential_drive.hpp"
#include "components/model/speed_limit.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/parameter_change.hpp"

namespace bw {

using namespace bandwagon_msgs::msg;

inline constexpr double kStep = 0.02;      // [s] of the robot and of what it publishes
inline const Pose2 kX_MO{4.0, -3.0, 2.0};  // odometry began somewhere in the map, and rotated
inline const Pose2 kStart{0.0, 0.0, 0.0};  // of the robot in the map
inline constexpr std::uint64_t kRequestId = 17;

/// The neighbours of the planner. The robot obeys at once; people and obstacles are in the map.
struct Neighbours {
  // What happens.
  std::map<int, std::uint8_t> requests;        ///< mode by step
  std::map<int, bw::SpeedLimit> speed_limits;  ///< by step
  std::vector<Pose2> path = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}};
  Obstacles obstacles;
  Tracks tracks;
  double tracks_age = 0.0;  ///< [s] of their stamp
  double xy_tolerance = 0.0;
  int odometry_ends = 1'000'000;
  int odometry_begins = 0;
  bool transforms = true;
  int transforms_end = 1'000'000;
  std::vector<NamedValue> change;  ///< of the planner's parameters, at 2.05 s
  // What is seen.
  Pose2 X_MB = kStart;
  Twist2 twist;
  std::vector<std::pair<double, Twist2>> commands;  ///< [s] since the start
  std::vector<bool> brakes_hard;                    ///< as it was told
  std::vector<FollowStatus> statuses;
  std::vector<PlannerCycle> cycles;
  nav_msgs::msg::Path plan;
  visualization_msgs::msg::MarkerArray markers;
  std::map<std::string, std::string> diagnostics;
  std::string diagnostic_message;
  std::vector<std::string> refusals;  ///< of the changes

  void configure(bw::Setup& setup) {
    setup.input<geometry_msgs::msg::Twist>("cmd_vel_nav", Qos::command(),
                                           [this](const auto& m, const Tick& tick) {
                                             twist = from_twist(m);
                                             commands.emplace_back(seconds_since_start(tick.now), twist);
                                           });
    setup.input<std_msgs::msg::Bool>(
        "brake_hard", Qos::standard(50),
        [this](const auto& m, const Tick&) { brakes_hard.push_back(m.data()); }, Need::optional);
    setup.input<FollowStatus>("follow_status", Qos::standard(50),
                              [this](const auto& m, const Tick&) { statuses.push_back(m); });
    setup.input<PlannerCycle>("local_planner_cycle", Qos::standard(50),
                              [this](const auto& m, const Tick&) { cycles.push_back(m); });
    setup.input<nav_msgs::msg::Path>("local_plan", Qos::standard(),
                                     [this](const auto& m, const Tick&) { plan = m; });
    setup.input<visualization_msgs::msg::MarkerArray>("local_planner_markers", Qos::standard(),
                                                      [this](const auto& m, const Tick&) { markers = m; });
    setup.input<diagnostic_msgs::msg::DiagnosticArray>(
        "/diagnostics", Qos::standard(),
        [this](const auto& m, const Tick&) {
          for (const auto& status : m.status()) {
            if (status.name() != "local_planner") continue;
            diagnostic_message = status.message();
            for (const auto& pair : status.values()) diagnostics[pair.key()] = pair.value();
          }
        },
        Need::optional);
    if (!change.empty()) change_parameters(setup, "/local_planner", 2.05, change, refusals);
    setup.every(
        Duration::seconds(kStep), "neighbours",
        [this, odometry = setup.output<nav_msgs::msg::Odometry>("odom"),
         obstacles_out = setup.output<Obstacles>("obstacles"), tracks_out = setup.output<Tracks>("tracks"),
         request = setup.output<FollowRequest>("follow_request"),
         speed_limit = setup.output<nav2_msgs::msg::SpeedLimit>("speed_limit"),
         tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) mutable {
          const int step = static_cast<int>(tick.sequence);
          X_MB = advance_exact(X_MB, twist, kStep);
          if (transforms && step < transforms_end) tf.publish(map_to_odom(tick.now));
          if (step >= odometry_begins && step < odometry_ends) odometry.publish(odom(tick.now));
          obstacles.header(make_header("map", tick.now));
          obstacles_out.publish(obstacles);
          tracks.header(make_header("map", tick.now - Duration::seconds(tracks_age)));
          tracks_out.publish(tracks);
          if (const auto limit = speed_limits.find(step); limit != speed_limits.end()) {
            nav2_msgs::msg::SpeedLimit limit_out;
            limit_out.percentage(limit->second.percentage);
            limit_out.speed_limit(limit->second.value);
            speed_limit.publish(limit_out);
          }
          if (!requests.contains(step)) return;
          FollowRequest message;
          message.id(kRequestId);
          message.mode(requests[step]);
          message.path(to_path("map", tick.now, path));
          message.xy_tolerance(xy_tolerance);
          request.publish(message);
        });
  }

  nav_msgs::msg::Odometry odom(Time now) const {
    nav_msgs::msg::Odometry message;
    message.header(make_header("odom", now));
    message.pose().pose(to_pose(inverse(kX_MO) * X_MB));
    message.twist().twist(to_twist_message(twist));
    return message;
  }
  static tf2_msgs::msg::TFMessage map_to_odom(Time now) {
    geometry_msgs::msg::TransformStamped transform;
    transform.header(make_header("map", now));
    transform.child_frame_id("odom");
    transform.transform().translation(to_vector3(kX_MO.position()));
    transform.transform().rotation(to_quaternion(kX_MO.theta));
    tf2_msgs::msg::TFMessage message;
    message.transforms().push_back(transform);
    return message;
  }
  void run(double seconds, const std::string& settings = "") {
    run_with_script("components: {local_planner: {" + settings + "}}", seconds,
                    [this](bw::Setup& setup) { configure(setup); });
  }
};

inline Obstacles one_disc(double x, double y, double radius) {
  Obstacles obstacles;
  obstacles.discs().resize(1);
  obstacles.discs()[0].x(static_cast<float>(x));
  obstacles.discs()[0].y(static_cast<float>(y));
  obstacles.discs()[0].radius(static_cast<float>(radius));
  return obstacles;
}

}  // namespace bw
