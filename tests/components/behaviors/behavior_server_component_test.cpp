// The behavior server on its actions and topics in lock-step: a script is its client, robot and senses. The
// robot obeys at once. A cycle is
// 0.1 s; a goal that comes between two is begun at the next one.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <gmock/gmock.h>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <nav_msgs/msg/odometry.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/model/differential_drive.hpp"
#include "tests/components/behaviors/action_log.hpp"

namespace bw {
namespace {

using Nav2 = JazzyNav2;
constexpr double kStep = 0.02;  // [s] of the robot and of what it publishes

struct Clients {
  ActionClient<Nav2::Spin> spin;
  ActionClient<Nav2::BackUp> back_up;
  ActionClient<Nav2::DriveOnHeading> drive;
  ActionClient<Nav2::Wait> wait;
};

/// What is around the server, and what it does.
struct Rig {
  std::map<int, std::function<void(const Clients&)>> acts;  ///< by hundredths of a second
  Twist2 start;                                             ///< the robot's velocity until the first command
  bandwagon_msgs::msg::Obstacles obstacles;
  bandwagon_msgs::msg::Tracks tracks;
  double odometry_ends = 1e9;    ///< [s]
  double obstacles_begin = 0.0;  ///< [s]
  std::function<void(bw::Setup&)> more = [](bw::Setup&) {};
  // What is seen.
  Pose2 pose;
  Twist2 twist;
  std::vector<std::pair<double, Twist2>> commands;  ///< [s] since the start

  void run(double seconds, const std::string& settings = "") {
    twist = start;
    run_with_script("components: {behavior_server: {" + settings + "}}", seconds, [this](bw::Setup& setup) {
      setup.input<geometry_msgs::msg::Twist>("cmd_vel_behavior", Qos::command(),
                                             [this](const auto& m, const Tick& tick) {
                                               twist = from_twist(m);
                                               commands.emplace_back(seconds_since_start(tick.now), twist);
                                             });
      setup.every(Duration::seconds(kStep), "robot",
                  [this, odometry = setup.output<nav_msgs::msg::Odometry>("odom"),
                   obstacles_out = setup.output<bandwagon_msgs::msg::Obstacles>("obstacles"),
                   tracks_out = setup.output<bandwagon_msgs::msg::Tracks>("tracks")](const Tick& tick) {
                    const double now = seconds_since_start(tick.now);
                    pose = advance_exact(pose, twist, kStep);
                    if (now < odometry_ends) odometry.publish(odom(tick.now));
                    obstacles.header(make_header("odom", tick.now));
                    if (now >= obstacles_begin) obstacles_out.publish(obstacles);
                    tracks.header(make_header("odom", tick.now));
                    tracks_out.publish(tracks);
                  });
      more(setup);
      setup.every(Duration::milliseconds(10), "acts", [this, clients = declare(setup)](const Tick& tick) {
        const auto act = acts.find(static_cast<int>(std::lround(100.0 * seconds_since_start(tick.now))));
        if (act != acts.end()) act->second(clients);
      });
    });
  }

 private:
  static Clients declare(bw::Setup& setup) {
    return {setup.action_client<Nav2::Spin>("spin"), setup.action_client<Nav2::BackUp>("backup"),
            setup.action_client<Nav2::DriveOnHeading>("drive_on_heading"),
            setup.action_client<Nav2::Wait>("wait")};
  }
  nav_msgs::msg::Odometry odom(Time now) const {
    nav_msgs::msg::Odometry message;
    message.header(make_header("odom", now));
    message.pose().pose(to_pose(pose));
    message.twist().twist(to_twist_message(twist));
    return message;
  }
};

void expect_end(const Attempt& attempt, GoalStatus status, std::uint16_t code, const std::string& text) {
  EXPECT_TRUE(attempt.accepted);
  EXPECT_EQ(attempt.acknowledged, 1);
  EXPECT_EQ(attempt.ends, 1);
  EXPECT_EQ(attempt.status, status);
  EXPECT_EQ(attempt.code, code);
  EXPECT_EQ(attempt.text, text);
}

TEST(BehaviorServer, SpinDriveBackUpAndWaitSucceedOneAfterTheOther) {
  Attempt spin, drive, back_up, wait;
  Rig rig;
  rig.acts[105] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(1.57), spin); };
  rig.acts[600] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(0.5, 0.25), drive);
  };
  rig.acts[1200] = [&](const Clients& c) {
    send_goal(c.back_up, drive_goal<Nav2::BackUp>(0.3, 0.15), back_up);
  };
  rig.acts[1800] = [&](const Clients& c) { send_goal(c.wait, wait_goal<Nav2::Wait>(1.5), wait); };
  rig.run(21.0);
  for (const Attempt* a : {&spin, &drive, &back_up, &wait}) expect_end(*a, GoalStatus::succeeded, 0, "");
  EXPECT_NEAR(rig.pose.theta, 1.57, 0.006);
  EXPECT_NEAR(rig.pose.position().dot(direction(1.57)), 0.2, 0.012);
  EXPECT_NEAR(spin.feedback.back(), 1.57, 0.006);
  EXPECT_NEAR(drive.feedback.back(), 0.5, 0.006);
  EXPECT_NEAR(back_up.feedback.back(), 0.3, 0.006);
  EXPECT_TRUE(std::is_sorted(spin.feedback.begin(), spin.feedback.end()));
  EXPECT_NEAR(spin.elapsed, spin.ended_at - 1.05, 0.011) << "from acceptance to the end";
  EXPECT_NEAR(wait.elapsed, 1.5, 1e-6);
  EXPECT_NEAR(wait.feedback.front(), 1.4, 1e-6);
  EXPECT_EQ(wait.feedback.back(), 0.0);
  EXPECT_NEAR(static_cast<double>(spin.feedback.size()), (spin.ended_at - 1.05) / 0.1, 1.0) << "each cycle";
  // Who waits, or is done, is silent: others may drive.
  for (const auto& [t, twist] : rig.commands) {
    EXPECT_FALSE(t > spin.ended_at + 0.001 && t < 6.0) << t;
    EXPECT_LT(t, 18.0);
  }
  EXPECT_EQ(rig.commands.back().second, Twist2{});
}

TEST(BehaviorServer, ANewerGoalOfAnyActionEndsTheOneInHand) {
  Attempt spin, drive, wait;
  Rig rig;
  rig.acts[100] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(6.0), spin); };
  rig.acts[300] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(3.0, 0.5), drive);
  };
  rig.acts[500] = [&](const Clients& c) { send_goal(c.wait, wait_goal<Nav2::Wait>(1.0), wait); };
  rig.run(8.0);
  expect_end(spin, GoalStatus::aborted, 700, "a newer goal came: drive_on_heading");
  EXPECT_NEAR(spin.ended_at, 3.0, 1e-6);
  expect_end(drive, GoalStatus::aborted, 720, "a newer goal came: wait");
  EXPECT_NEAR(drive.ended_at, 5.0, 1e-6);
  expect_end(wait, GoalStatus::succeeded, 0, "");
  // At the moment of each change it is told to stop.
  for (const double t : {3.0, 5.0}) {
    EXPECT_TRUE(std::ranges::any_of(rig.commands, [&](const auto& command) {
      return std::abs(command.first - t) < 1e-6 && command.second == Twist2{};
    })) << t;
  }
  EXPECT_EQ(rig.twist, Twist2{});
}

// Of those that move: who waits needs no base.
TEST(BehaviorServer, ABaseThatHasToBeReleasedEndsAMotionWithItsReason) {
  Attempt drive, spin, wait;
  bandwagon_msgs::msg::BaseState base;
  Rig rig;
  rig.more = [&](bw::Setup& setup) {
    setup.every(Duration::milliseconds(100), "base",
                [&, out = setup.output<bandwagon_msgs::msg::BaseState>("base_state")](const Tick&) {
                  out.publish(base);
                });
  };
  rig.acts[100] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(3.0, 0.5), drive);
  };
  rig.acts[205] = [&](const Clients&) {
    base.is_latched(true);
    base.reason("bumper left");
  };
  rig.acts[300] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(1.0), spin); };
  rig.acts[400] = [&](const Clients& c) { send_goal(c.wait, wait_goal<Nav2::Wait>(1.0), wait); };
  rig.run(6.0);
  const std::string reason = "the base stands: bumper left; until release_stop";
  expect_end(drive, GoalStatus::aborted, 720, reason);
  EXPECT_NEAR(drive.ended_at, 2.1, 0.11);
  expect_end(spin, GoalStatus::aborted, 700, reason);
  EXPECT_NEAR(spin.ended_at, 3.0, 0.11);
  expect_end(wait, GoalStatus::succeeded, 0, "");
  EXPECT_EQ(rig.twist, Twist2{});
}

TEST(BehaviorServer, ACanceledGoalStopsAtOnce) {
  Attempt drive, again;
  GoalId id{};
  Rig rig;
  rig.acts[100] = [&](const Clients& c) {
    id = send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(3.0, 0.5), drive);
  };
  rig.acts[250] = [&](const Clients& c) {
    c.drive.cancel(id);
    c.drive.cancel(id);
    c.spin.cancel(id);  // of another action: unknown there
  };
  rig.acts[400] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(0.2, 0.2), again);
  };
  rig.run(8.0);
  expect_end(drive, GoalStatus::canceled, 0, "");
  EXPECT_NEAR(drive.ended_at, 2.5, 1e-6);
  expect_end(again, GoalStatus::succeeded, 0, "");
  const auto silent = [&](const auto& c) { return c.first > 2.61 && c.first < 4.0; };
  EXPECT_TRUE(std::ranges::none_of(rig.commands, silent));
}

TEST(BehaviorServer, OfFiftyGoalsAtOnceTheLastIsDone) {
  std::vector<Attempt> attempts(50);
  Rig rig;
  rig.acts[100] = [&](const Clients& c) {
    for (Attempt& attempt : attempts) send_goal(c.spin, spin_goal<Nav2::Spin>(0.5), attempt);
  };
  rig.run(4.0);
  for (std::size_t i = 0; i + 1 < attempts.size(); ++i)
    expect_end(attempts[i], GoalStatus::aborted, 700, "a newer goal came: spin");
  expect_end(attempts.back(), GoalStatus::succeeded, 0, "");
  EXPECT_NEAR(rig.pose.theta, 0.5, 0.006);
}

TEST(BehaviorServer, GoalsThatAreNoneEndWithTheCodeOfTheirAction) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::map<int, Attempt> a;
  Rig rig;
  rig.acts[100] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(kNan), a[0]); };
  rig.acts[150] = [&](const Clients& c) { send_goal(c.back_up, drive_goal<Nav2::BackUp>(0.3, kNan), a[1]); };
  rig.acts[200] = [&](const Clients& c) {
    auto goal = drive_goal<Nav2::DriveOnHeading>(0.3, 0.1);
    goal.target().y(0.1);
    send_goal(c.drive, goal, a[2]);
  };
  rig.acts[250] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(-0.3, 0.1), a[3]);
  };
  rig.acts[300] = [&](const Clients& c) { send_goal(c.wait, wait_goal<Nav2::Wait>(-2.0), a[4]); };
  rig.run(4.0);
  expect_end(a[0], GoalStatus::aborted, 700, "target_yaw is not finite");
  expect_end(a[1], GoalStatus::aborted, 713, "the speed is not finite");
  expect_end(a[2], GoalStatus::aborted, 724, "target.y and target.z must be 0: only x is driven");
  expect_end(a[3], GoalStatus::aborted, 724, "target.x and speed must have the same sign");
  expect_end(a[4], GoalStatus::succeeded, 0, "");
  EXPECT_TRUE(rig.commands.empty());
}

TEST(BehaviorServer, WithoutSensesNothingMoves) {
  std::map<int, Attempt> a;
  Rig no_odometry;
  no_odometry.odometry_ends = 0.0;
  no_odometry.acts[100] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(1.0), a[0]); };
  no_odometry.run(2.0);
  expect_end(a[0], GoalStatus::aborted, 702, "no odometry yet");
  Rig blind;
  blind.obstacles_begin = 3.0;
  blind.acts[100] = [&](const Clients& c) { send_goal(c.back_up, drive_goal<Nav2::BackUp>(0.3, 0.1), a[1]); };
  blind.run(2.0);
  expect_end(a[1], GoalStatus::aborted, 712, "no obstacles yet");
  Rig stale;
  stale.odometry_ends = 2.0;
  stale.acts[100] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(3.0, 0.3), a[2]);
  };
  stale.acts[300] = [&](const Clients& c) { send_goal(c.wait, wait_goal<Nav2::Wait>(0.5), a[3]); };
  stale.run(5.0, "inputs: {odom: {max_age: 500ms, on_stale: stop}}");
  expect_end(a[2], GoalStatus::aborted, 722, "a needed input is stale");
  EXPECT_NEAR(a[2].ended_at, 2.55, 0.06);
  EXPECT_EQ(stale.twist, Twist2{});
  expect_end(a[3], GoalStatus::succeeded, 0, "");  // it needs none
}

TEST(BehaviorServer, ThingsAndPeopleInTheWayEndItAndTimeDoes) {
  std::map<int, Attempt> a;
  Rig thing;
  thing.obstacles.discs().resize(1);
  thing.obstacles.discs()[0].x(-0.7F);
  thing.obstacles.discs()[0].radius(0.2F);
  thing.acts[100] = [&](const Clients& c) { send_goal(c.back_up, drive_goal<Nav2::BackUp>(0.5, 0.1), a[0]); };
  thing.run(8.0);
  expect_end(a[0], GoalStatus::aborted, 714, "something is in the way");
  EXPECT_GT(thing.pose.x, -0.2);
  Rig person;
  person.tracks.tracks().resize(1);
  auto& track = person.tracks.tracks()[0];
  track.radius(0.3F);
  track.confidence(1.0);
  track.position().x(1.0);
  track.position().y(-1.5);
  track.velocity().y(0.8);
  person.acts[100] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(2.0, 0.5), a[1]);
  };
  person.run(6.0);
  expect_end(a[1], GoalStatus::aborted, 723, "something is in the way");
  EXPECT_EQ(person.twist, Twist2{});
  Rig slow;
  slow.acts[100] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(6.0, 2.0), a[2]); };
  slow.run(5.0);
  expect_end(a[2], GoalStatus::aborted, 701, "the time allowance was over before the target was reached");
  EXPECT_NEAR(a[2].ended_at, 3.1, 0.051);
}

TEST(BehaviorServer, DeactivationEndsTheGoalAndTheMotion) {
  using lifecycle_msgs::srv::ChangeState;
  Attempt drive, late;
  Rig rig;
  Client<ChangeState> change_state;
  rig.more = [&](bw::Setup& setup) {
    change_state = setup.client<ChangeState>("behavior_server/change_state");
  };
  rig.acts[100] = [&](const Clients& c) {
    send_goal(c.drive, drive_goal<Nav2::DriveOnHeading>(3.0, 0.5), drive);
  };
  rig.acts[300] = [&](const Clients&) {
    ChangeState::Request request;
    request.transition().id(4);  // deactivate
    change_state.call(request, Duration::milliseconds(500), [](const auto*, const Tick&) {});
  };
  rig.acts[400] = [&](const Clients& c) { send_goal(c.spin, spin_goal<Nav2::Spin>(1.0), late); };
  rig.run(6.0);
  EXPECT_EQ(drive.ends, 1);
  EXPECT_EQ(drive.status, GoalStatus::aborted);
  EXPECT_EQ(drive.code, 720);
  EXPECT_NE(drive.text, "");
  EXPECT_EQ(late.acknowledged, 1);
  EXPECT_FALSE(late.accepted);
  EXPECT_NEAR(rig.commands.back().first, 3.0, 1e-6);
  EXPECT_EQ(rig.commands.back().second, Twist2{});
}

/// A spin, and a drive to which something is near, over the layout of a distribution.
template <class Layout>
std::pair<Attempt, Attempt> drive_in(const std::string& distro, bool disable_checks) {
  Attempt spin, drive;
  const std::string yaml = "ros_distro: " + distro + "\ncomponents: {behavior_server: {}}";
  Twist2 twist;
  Pose2 pose;
  run_with_script(yaml, 12.0, [&](bw::Setup& setup) {
    setup.input<geometry_msgs::msg::Twist>("cmd_vel_behavior", Qos::command(),
                                           [&](const auto& m, const Tick&) { twist = from_twist(m); });
    const auto spins = setup.action_client<typename Layout::Spin>("spin");
    const auto drives = setup.action_client<typename Layout::DriveOnHeading>("drive_on_heading");
    setup.every(Duration::seconds(kStep), "robot",
                [&, spins, drives, odometry = setup.output<nav_msgs::msg::Odometry>("odom"),
                 obstacles = setup.output<bandwagon_msgs::msg::Obstacles>("obstacles"),
                 tracks = setup.output<bandwagon_msgs::msg::Tracks>("tracks")](const Tick& tick) {
                  pose = advance_exact(pose, twist, kStep);
                  nav_msgs::msg::Odometry message;
                  message.header(make_header("odom", tick.now));
                  message.pose().pose(to_pose(pose));
                  message.twist().twist(to_twist_message(twist));
                  odometry.publish(message);
                  bandwagon_msgs::msg::Obstacles ring;
                  ring.header(message.header());
                  for (const double angle : {0.5, 1.5708, 3.0}) {
                    ring.discs().emplace_back();
                    ring.discs().back().x(static_cast<float>(0.6 * std::cos(angle)));
                    ring.discs().back().y(static_cast<float>(0.6 * std::sin(angle)));
                    ring.discs().back().radius(0.1F);
                  }
                  obstacles.publish(ring);
                  bandwagon_msgs::msg::Tracks nobody;
                  nobody.header(message.header());
                  tracks.publish(nobody);
                  if (tick.sequence == 50) send_goal(spins, spin_goal<typename Layout::Spin>(1.5708), spin);
                  if (tick.sequence != 300) return;
                  auto goal = drive_goal<typename Layout::DriveOnHeading>(0.25, 0.2);
                  if constexpr (requires { goal.disable_collision_checks(true); })
                    goal.disable_collision_checks(disable_checks);
                  send_goal(drives, goal, drive);
                });
  });
  return {spin, drive};
}

TEST(BehaviorServer, EachDistributionHasItsLayout) {
  const std::string blocked = "something is in the way";
  {
    const auto [spin, drive] = drive_in<HumbleNav2>("humble", false);
    expect_end(spin, GoalStatus::succeeded, 0, "");
    expect_end(drive, GoalStatus::aborted, 0, "");  // its result has no field for more
  }
  {
    const auto [spin, drive] = drive_in<JazzyNav2>("jazzy", false);
    expect_end(spin, GoalStatus::succeeded, 0, "");
    expect_end(drive, GoalStatus::aborted, 723, blocked);
  }
  {
    const auto [spin, drive] = drive_in<KiltedNav2>("kilted", false);
    expect_end(drive, GoalStatus::aborted, 723, blocked);
    expect_end(drive_in<KiltedNav2>("kilted", true).second, GoalStatus::succeeded, 0, "");
  }
  expect_end(drive_in<LyricalNav2>("lyrical", true).second, GoalStatus::succeeded, 0, "");
}

}  // namespace
}  // namespace bw
