// Multiplexer and collision monitor on their topics: a script plays planner, hand, laser and odometry.
// Expected times: a command goes on at the instant it comes; the end of one is noticed after its time-out of
// 200 ms, within 10 ms.
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <gmock/gmock.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/empty.hpp>

#include "components/messages/geometry.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using geometry_msgs::msg::Twist;
using geometry_msgs::msg::TwistStamped;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
using Wish = std::function<std::optional<Twist2>(double t)>;

struct Given {
  double t = 0.0;  ///< [s] after the start
  Twist2 twist;
};

struct Drive {
  std::vector<Given> muxed, commands;
  std::vector<bool> overrides;
  std::string diagnostics;  ///< of twist_mux

  static Given at(const std::vector<Given>& all, double t) {
    Given last;
    for (const Given& given : all) {
      if (given.t <= t + 1e-9) last = given;
    }
    return last;
  }
};

std::optional<Twist2> nothing(double) { return std::nullopt; }

struct Wishes {
  Wish planner = nothing;          ///< at 10 Hz
  Wish hand = nothing;             ///< at 20 Hz
  Wish stamped = nothing;          ///< at 20 Hz
  Duration age = {};               ///< of the stamps
  double release = -1.0;           ///< when [s]
  std::vector<double> goals = {};  ///< when each is accepted [s]
};

sensor_msgs::msg::LaserScan room(const Tick& tick) {
  constexpr int kBeams = 541;
  sensor_msgs::msg::LaserScan scan;
  scan.header(make_header("laser", tick.now));
  scan.angle_min(-2.35619449F);
  scan.angle_max(2.35619449F);
  scan.angle_increment(4.71238898F / (kBeams - 1));
  scan.range_min(0.05F);
  scan.range_max(20.0F);
  std::vector<float> ranges(kBeams, 5.0F);
  for (std::size_t i = 0; i < ranges.size(); i += 7)
    ranges[i] += 1e-4F * static_cast<float>((tick.sequence + i) % 11);
  scan.ranges(std::move(ranges));
  return scan;
}

template <class Publish>
void speak(Setup& setup, int period_ms, const std::string& name, const Wish& wish, Publish publish) {
  setup.every(Duration::milliseconds(period_ms), name, [wish, publish](const Tick& tick) {
    if (const auto twist = wish(seconds_since_start(tick.now))) publish(*twist, tick.now);
  });
}

Drive run(double seconds, const Wishes& wishes, const std::string& parameters = "") {
  Drive drive;
  run_with_script(
      "components: {twist_mux: {" + parameters + "}, collision_monitor: {remap: {cmd_vel_nav: cmd_vel_mux}}}",
      seconds, [&](Setup& setup) {
        const auto keep = [](std::vector<Given>& all) {
          return [&all](const auto& m, const Tick& tick) {
            all.push_back({seconds_since_start(tick.now), from_twist(m)});
          };
        };
        setup.input<Twist>("cmd_vel_mux", Qos::standard(50), keep(drive.muxed));
        setup.input<Twist>("cmd_vel", Qos::standard(50), keep(drive.commands));
        setup.input<diagnostic_msgs::msg::DiagnosticArray>(
            "/diagnostics", Qos::standard(),
            [&](const auto& m, const Tick&) {
              for (const auto& status : m.status()) {
                if (status.name() != "twist_mux") continue;
                drive.diagnostics = status.message();
                for (const auto& value : status.values())
                  drive.diagnostics += "\n" + value.key() + ": " + value.value();
              }
            },
            Need::optional);
        setup.every(Duration::milliseconds(20), "odometry",
                    [out = setup.output<nav_msgs::msg::Odometry>("odom")](const Tick& tick) {
                      nav_msgs::msg::Odometry odometry;
                      odometry.header(make_header("odom", tick.now));
                      odometry.pose().pose(to_pose({0.5 * seconds_since_start(tick.now), 0.0, 0.0}));
                      odometry.twist().twist(to_twist_message({0.5, 0.0}));
                      out.publish(odometry);
                    });
        setup.every(Duration::milliseconds(100), "laser",
                    [out = setup.output<sensor_msgs::msg::LaserScan>("scan")](const Tick& tick) {
                      out.publish(room(tick));
                    });
        setup.input<std_msgs::msg::Bool>("manual_override", Qos::latched(), [&](const auto& m, const Tick&) {
          drive.overrides.push_back(m.data());
        });
        setup.every(Duration::milliseconds(50), "people",
                    [&wishes, released = setup.output<std_msgs::msg::Empty>("stop_released"),
                     status = setup.output<bandwagon_msgs::msg::NavigationStatus>(
                         "navigation_status", Qos::latched())](const Tick& tick) {
                      const auto is_now = [&](double t) {
                        return std::abs(seconds_since_start(tick.now) - t) < 1e-6;
                      };
                      if (is_now(wishes.release)) released.publish({});
                      for (std::size_t i = 0; i < wishes.goals.size(); ++i) {
                        if (!is_now(wishes.goals[i])) continue;
                        bandwagon_msgs::msg::NavigationStatus message;
                        message.goal_id(i + 1);
                        message.status(bandwagon_msgs::msg::NavigationStatus_Constants::ACCEPTED);
                        status.publish(message);
                      }
                    });
        speak(setup, 100, "planner", wishes.planner,
              [out = setup.command<Twist>("cmd_vel_nav")](const Twist2& twist, Time) {
                out.publish(to_twist_message(twist));
              });
        speak(setup, 50, "hand", wishes.hand,
              [out = setup.output<Twist>("cmd_vel_teleop")](const Twist2& twist, Time) {
                out.publish(to_twist_message(twist));
              });
        speak(setup, 50, "stamped", wishes.stamped,
              [out = setup.output<TwistStamped>("cmd_vel_teleop_stamped"), age = wishes.age](
                  const Twist2& twist, Time now) {
                TwistStamped message;
                message.header(make_header("", now - age));
                message.twist(to_twist_message(twist));
                out.publish(message);
              });
      });
  return drive;
}

Wish between(double from, double to, const Twist2& twist) {
  return [=](double t) { return t > from - 1e-6 && t < to + 1e-6 ? std::optional(twist) : std::nullopt; };
}

const Twist2 kNav{0.5, 0.2}, kHand{0.3, -0.4};

// Today's rule was that the planner went on 1 s after the last key: who had driven the robot out of the way
// and let go was surprised.
TEST(TwistMuxComponent, TheHandDrivesAlonePromptlyAndThePlannerGoesOnAfterARelease) {
  const Drive drive =
      run(60.0, {.planner = between(0.0, 60.0, kNav), .hand = between(1.0, 2.0, kHand), .release = 50.0});
  EXPECT_EQ(Drive::at(drive.commands, 0.99).twist, kNav);
  for (const Given& given : drive.muxed) {
    if (given.t > 1.0 + 1e-6 && given.t < 2.2) {
      EXPECT_EQ(given.twist, kHand) << given.t;
    }
    if (given.t > 2.2 && given.t < 50.0) {
      EXPECT_EQ(given.twist, Twist2{}) << given.t;
    }
  }
  EXPECT_NEAR(Drive::at(drive.commands, 1.05).t, 1.05, 1e-9);  // at the instant it came
  EXPECT_EQ(Drive::at(drive.commands, 1.05).twist, kHand);
  // Silent after 2.0 s.
  EXPECT_EQ(Drive::at(drive.commands, 2.19).twist, kHand);
  EXPECT_EQ(Drive::at(drive.commands, 2.21).twist, Twist2{});
  EXPECT_EQ(Drive::at(drive.commands, 49.99).twist, Twist2{});
  EXPECT_EQ(Drive::at(drive.commands, 50.1).twist, kNav);  // the first of the planner's after the release
  EXPECT_EQ(drive.overrides, (std::vector<bool>{true, false}));
}

TEST(TwistMuxComponent, AnotherGoalIsDrivenWithoutARelease) {
  const Drive drive = run(
      6.0, {.planner = between(0.0, 6.0, kNav), .hand = between(1.0, 2.0, kHand), .goals = {0.5, 1.5, 4.0}});
  EXPECT_EQ(Drive::at(drive.commands, 0.99).twist, kNav);
  EXPECT_EQ(Drive::at(drive.commands, 3.99).twist, Twist2{});  // that of 1.5 s came while the hand drove
  EXPECT_EQ(Drive::at(drive.commands, 4.1).twist, kNav);
}

TEST(TwistMuxComponent, StampedCommandsCountLikeOthersUnlessTheyAreOld) {
  EXPECT_EQ(Drive::at(run(2.0, {.stamped = between(1.0, 2.0, kHand)}).commands, 1.5).twist, kHand);
  const Wishes old{.planner = between(0.0, 2.0, kNav),
                   .stamped = between(1.0, 1.95, kHand),
                   .age = Duration::milliseconds(510)};
  const Drive drive = run(2.5, old);
  EXPECT_EQ(Drive::at(drive.commands, 1.5).twist, kNav);
  EXPECT_THAT(
      drive.diagnostics,
      testing::HasSubstr(
          "cmd_vel_teleop_stamped: refused: 0 not finite, 20 for their stamps, the last: late, 0.51 s old"));
}

TEST(TwistMuxComponent, WhatIsNoNumberIsCountedAndMovesNothing) {
  const Drive drive = run(2.5, {.planner = between(0.0, 2.0, kNav), .hand = between(1.0, 1.95, {kNan, 0.0})});
  EXPECT_EQ(Drive::at(drive.commands, 1.5).twist, kNav);
  EXPECT_THAT(drive.diagnostics, testing::HasSubstr("20 commands refused"));
  EXPECT_THAT(drive.diagnostics,
              testing::HasSubstr("cmd_vel_teleop: refused: 20 not finite, 0 for their stamps"));
}

TEST(TwistMuxComponent, ThePlannersCommandsGoOnAsTheyCome) {
  const Drive drive = run(2.05, {.planner = between(0.0, 3.0, kNav)});
  ASSERT_EQ(drive.muxed.size(), 20U);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_NEAR(drive.muxed[i].t, 0.1 * static_cast<double>(i + 1), 1e-9);
    EXPECT_EQ(drive.muxed[i].twist, kNav);
  }
}

TEST(TwistMuxComponent, PrioritiesAreThoseOfTheGraph) {
  const std::string reversed =
      "parameters: {sources: [{topic: cmd_vel_nav, priority: 9, timeout: 0.2}, {topic: cmd_vel_teleop, priority: 3}, {topic: "
      "cmd_vel_teleop_stamped, priority: 2, stamped: true}]}";
  const Drive drive =
      run(2.0, {.planner = between(0.0, 5.0, kNav), .hand = between(1.0, 2.0, kHand)}, reversed);
  for (const Given& given : drive.muxed) EXPECT_EQ(given.twist, kNav) << given.t;
}

}  // namespace
}  // namespace bw
