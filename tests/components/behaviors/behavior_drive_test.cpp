// Goals of the behavior server driven by the simulated robot: laser, people, costmap, multiplexer, collision
// monitor, motor control, wheels. Somebody else wants to drive all the time, as a planner does.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gmock/gmock.h>
#include <sensor_msgs/msg/joint_state.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "tests/components/behaviors/action_log.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::GroundTruth;
using Nav2 = JazzyNav2;

const char* const kRoom = R"(
components:
  world:
    parameters:
      truth_rate: 50.0
      walls:
        - {x1: -4.0, y1: -3.0, x2: 4.0, y2: -3.0}
        - {x1: -4.0, y1: 3.0, x2: 4.0, y2: 3.0}
        - {x1: 4.0, y1: -3.0, x2: 4.0, y2: 3.0}
        - {x1: -4.0, y1: -3.0, x2: -4.0, y2: 3.0}
      people_react: false
      people: {scripted: [PEOPLE]}
  robot_base: {}
  twist_mux:
    inputs:
      cmd_vel_teleop: {external: true}
      cmd_vel_teleop_stamped: {external: true}
  collision_monitor: {remap: {cmd_vel_nav: cmd_vel_mux}}
  motor_control: {}
  people: {}
  local_costmap: {}
  behavior_server:
    inputs:
      odom: {max_age: 500ms, on_stale: stop}
      tracks: {max_age: 1000ms, on_stale: stop}
      obstacles: {max_age: 1000ms, on_stale: stop}
)";

struct Clients {
  ActionClient<Nav2::Spin> spin;
  ActionClient<Nav2::BackUp> back_up;
  ActionClient<Nav2::DriveOnHeading> drive;
};

struct Room {
  std::string people;
  Twist2 planner;                                           ///< what it wants, at 10 Hz
  std::map<int, std::function<void(const Clients&)>> acts;  ///< by tenths of a second
  // What is seen.
  std::vector<std::pair<double, Pose2>> poses;
  std::vector<std::pair<double, Twist2>> twists;
  std::vector<std::pair<double, Twist2>> muxed;
  double rotated = 0.0;
  std::uint32_t contacts = 0;

  Pose2 at(double t) const {
    const auto later = std::ranges::find_if(poses, [&](const auto& p) { return p.first > t; });
    return later == poses.end() ? poses.back().second : later->second;
  }
  void run(double seconds) {
    std::string yaml = kRoom;
    yaml.replace(yaml.find("PEOPLE"), 6, people);
    run_with_script(yaml, seconds, [this](bw::Setup& setup) {
      setup.input<GroundTruth>("sim/ground_truth", Qos::standard(50),
                               [this](const GroundTruth& truth, const Tick& tick) { see(truth, tick); });
      setup.input<geometry_msgs::msg::Twist>(
          "cmd_vel_mux", Qos::standard(50), [this](const auto& m, const Tick& tick) {
            muxed.emplace_back(seconds_since_start(tick.now), from_twist(m));
          });
      setup.every(Duration::milliseconds(100), "planner and client",
                  [this, wish = setup.command<geometry_msgs::msg::Twist>("cmd_vel_nav"),
                   clients = Clients{
                       setup.action_client<Nav2::Spin>("spin"), setup.action_client<Nav2::BackUp>("backup"),
                       setup.action_client<Nav2::DriveOnHeading>("drive_on_heading")}](const Tick& tick) {
                    wish.publish(to_twist_message(planner));
                    const auto act =
                        acts.find(static_cast<int>(std::lround(10.0 * seconds_since_start(tick.now))));
                    if (act != acts.end()) act->second(clients);
                  });
    });
  }

 private:
  void see(const GroundTruth& truth, const Tick& tick) {
    const Pose2 pose = from_pose(truth.pose());
    if (!poses.empty()) rotated += wrap_angle(pose.theta - poses.back().second.theta);
    poses.emplace_back(seconds_since_start(tick.now), pose);
    twists.emplace_back(seconds_since_start(tick.now), from_twist(truth.twist()));
    contacts = truth.contacts();
  }
};

// Odometry of perfect encoders: a tick of one wheel is 0.5 mrad. The rest is what the robot still rotates
// when it counts as arrived, 5 mrad, and how it comes to rest.
TEST(BehaviorDrive, SpinsEndAtTheirAngle) {
  for (const double yaw : {1.57, -1.57, 3.0, -3.0, 6.28}) {
    Attempt attempt;
    Room room;
    room.acts[10] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(yaw, 12.0), attempt); };
    room.run(10.5);
    EXPECT_EQ(attempt.status, GoalStatus::succeeded) << yaw << " " << attempt.text;
    EXPECT_NEAR(room.rotated, yaw, 0.01);
    EXPECT_LT(room.poses.back().second.position().norm(), 0.005);
    RecordProperty("error_" + std::to_string(yaw), std::to_string(room.rotated - yaw));
  }
}

// Backwards the monitor lets it creep with 0.1 m/s: the laser does not see there.
TEST(BehaviorDrive, DrivesEndAtTheirDistance) {
  Attempt ahead, back, fast;
  Room room;
  room.acts[10] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(0.3, 0.15, 10.0), ahead);
  };
  room.acts[60] = [&](const Clients& c) {
    send_goal(c.back_up, drive_goal<Nav2::BackUp>(0.3, 0.15, 10.0), back);
  };
  room.acts[130] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(1.5, 1.0, 10.0), fast);
  };
  room.run(18.0);
  for (const Attempt* a : {&ahead, &back, &fast}) EXPECT_EQ(a->status, GoalStatus::succeeded) << a->text;
  RecordProperty("ends", std::to_string(room.at(5.9).x) + " " + std::to_string(room.at(12.9).x) + " " +
                             std::to_string(room.poses.back().second.x));
  EXPECT_NEAR(room.at(5.9).x, 0.3, 0.01);
  EXPECT_NEAR(room.at(12.9).x, 0.0, 0.02);
  EXPECT_NEAR(room.poses.back().second.x, 1.5, 0.03);
  EXPECT_EQ(room.twists.back().second.v, 0.0);
}

TEST(BehaviorDrive, ThePlannerIsHeardBeforeAndAQuarterOfASecondAfterIt) {
  Attempt attempt;
  Room room;
  room.planner = {0.1, 0.0};
  room.acts[20] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(1.57, 10.0), attempt); };
  room.run(8.0);
  ASSERT_EQ(attempt.status, GoalStatus::succeeded) << attempt.text;
  for (const auto& [t, twist] : room.muxed) {
    if (t < 2.0 || t > attempt.ended_at + 0.36) {
      EXPECT_EQ(twist, room.planner) << t;
    } else if (t > 2.11 && t < attempt.ended_at + 0.24) {
      EXPECT_EQ(twist.v, 0.0) << t;
    }
  }
  // The first of the planner's after the time-out of 0.25 s: at 10 Hz within 0.35 s.
  const auto next = std::ranges::find_if(room.muxed, [&](const auto& m) {
    return m.first > attempt.ended_at + 1e-6 && m.second == room.planner;
  });
  ASSERT_NE(next, room.muxed.end());
  EXPECT_LE(next->first - attempt.ended_at, 0.35 + 1e-6);
}

// They cross 1 m ahead of the robot when it would be there.
TEST(BehaviorDrive, SomebodyWhoWalksIntoTheWayEndsItWithoutContact) {
  Attempt attempt;
  Room room;
  room.people = "{waypoints: [{x: 1.4, y: -2.5}, {x: 1.4, y: 2.5}], speed: 1.0}";
  room.acts[10] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(3.0, 0.6, 20.0), attempt);
  };
  room.run(8.0);
  EXPECT_EQ(attempt.status, GoalStatus::aborted);
  EXPECT_EQ(attempt.code, 723) << attempt.text;
  EXPECT_EQ(room.contacts, 0U);
  EXPECT_EQ(room.twists.back().second.v, 0.0);
}

TEST(BehaviorDrive, AWallAheadEndsItBeforeTheMonitorHasTo) {
  Attempt attempt;
  Room room;
  room.acts[10] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(6.0, 0.8, 20.0), attempt);
  };
  room.run(12.0);
  EXPECT_EQ(attempt.code, 723) << attempt.text;
  EXPECT_EQ(room.contacts, 0U);
  EXPECT_GT(room.poses.back().second.x,
            1.5);  // the wall's face is 3.7 m ahead: 2 s at 0.8 m/s, and the cells of the costmap
}

}  // namespace
}  // namespace bw
