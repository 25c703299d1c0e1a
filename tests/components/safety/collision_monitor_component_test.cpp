// The collision monitor on its topics: a script plays laser, odometry and planner.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <geometry_msgs/msg/twist.hpp>
#include <gtest/gtest.h>
#include <nav2_msgs/msg/collision_monitor_state.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <std_msgs/msg/empty.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/geometry.hpp"
#include "runtime/wire/serialization.hpp"
#include "tests/components/component_rig.hpp"
#include "tests/components/transitions.hpp"

namespace bw {
namespace {

using sensor_msgs::msg::LaserScan;

constexpr int kBeams = 541;

/// 270 degrees, everything at `range` [m]; the last digit of a few ranges changes with time.
LaserScan scan_at(const Tick& tick, float range) {
  LaserScan scan;
  scan.header(make_header("laser", tick.now));
  scan.angle_min(-2.35619449F);
  scan.angle_max(2.35619449F);
  scan.angle_increment(4.71238898F / (kBeams - 1));
  scan.range_min(0.05F);
  scan.range_max(20.0F);
  std::vector<float> ranges(kBeams, range);
  for (std::size_t i = 0; i < ranges.size(); i += 7)
    ranges[i] += 1e-4F * static_cast<float>((tick.sequence + i) % 11);
  scan.ranges(std::move(ranges));
  return scan;
}

struct Given {
  double t = 0.0;  ///< [s] after the start
  Twist2 twist;
};

struct Drive {
  std::vector<Given> commands;                               ///< on cmd_vel
  std::vector<std::pair<std::uint8_t, std::string>> states;  ///< one for each command
  std::size_t markers = 0;

  Given at(double t) const {
    Given last;
    for (const Given& given : commands) {
      if (given.t <= t + 1e-9) last = given;
    }
    return last;
  }
};

/// `wish` at 10 Hz, `laser` at 10 Hz, odometry at 50 Hz that says `speed`.
Drive run(double seconds, double speed, const std::function<std::optional<Twist2>(double t)>& wish,
          const std::function<std::optional<LaserScan>(double t, const Tick&)>& laser,
          const std::string& parameters = "", double reset_at = -1.0, const std::string& head = "",
          const std::vector<std::pair<double, std::string>>& transitions = {}) {
  Drive drive;
  run_with_script(head + "components: {collision_monitor: {" + parameters + "}}", seconds, [&](Setup& setup) {
    change_states(setup, "collision_monitor", transitions);
    setup.input<geometry_msgs::msg::Twist>(
        "cmd_vel", Qos::standard(50), [&](const auto& m, const Tick& tick) {
          drive.commands.push_back({seconds_since_start(tick.now), from_twist(m)});
        });
    setup.input<nav2_msgs::msg::CollisionMonitorState>(
        "collision_monitor_state", Qos::standard(50),
        [&](const auto& m, const Tick&) { drive.states.emplace_back(m.action_type(), m.polygon_name()); });
    setup.input<visualization_msgs::msg::MarkerArray>(
        "collision_monitor_markers", Qos::standard(),
        [&](const auto& m, const Tick&) { drive.markers += m.markers().size(); });
    setup.every(Duration::milliseconds(20), "odometry",
                [&, speed, out = setup.output<nav_msgs::msg::Odometry>("odom")](const Tick& tick) {
                  nav_msgs::msg::Odometry odometry;
                  odometry.header(make_header("odom", tick.now));
                  odometry.pose().pose(to_pose({speed * seconds_since_start(tick.now), 0.0, 0.0}));
                  odometry.twist().twist(to_twist_message({speed, 0.0}));
                  out.publish(odometry);
                });
    setup.every(Duration::milliseconds(100), "laser",
                [&, out = setup.output<LaserScan>("scan")](const Tick& tick) {
                  if (const auto scan = laser(seconds_since_start(tick.now), tick)) out.publish(*scan);
                });
    setup.every(Duration::milliseconds(100), "wish",
                [&, out = setup.command<geometry_msgs::msg::Twist>("cmd_vel_nav")](const Tick& tick) mutable {
                  if (const auto twist = wish(seconds_since_start(tick.now)))
                    out.publish(to_twist_message(*twist));
                });
    setup.every(Duration::milliseconds(100), "reset",
                [&, out = setup.output<std_msgs::msg::Empty>("collision_monitor/reset")](const Tick& tick) {
                  if (std::abs(seconds_since_start(tick.now) - reset_at) < 0.05) out.publish({});
                });
  });
  return drive;
}

std::optional<LaserScan> room(double, const Tick& tick) { return scan_at(tick, 5.0F); }
std::optional<Twist2> ahead(double) { return Twist2{0.8, 0.2}; }

TEST(CollisionMonitorComponent, PassesCommandsOnAtOnceAndKeepsThemFreshBetween) {
  const Drive drive = run(2.0, 0.8, ahead, room);
  EXPECT_EQ(drive.at(1.0).twist, (Twist2{0.8, 0.2}));
  EXPECT_NEAR(drive.at(1.0).t, 1.0, 1e-6);  // the command of this very moment
  EXPECT_NEAR(drive.at(1.05).t, 1.04, 1e-6);
  ASSERT_EQ(drive.states.size(), drive.commands.size());
  EXPECT_EQ(drive.states.back().first, 0);
  EXPECT_GT(drive.markers, 5U);
}

// The laser looks back over 270 degrees: backward the path is seen and free, forward nothing is seen. Who
// takes it for one that looks ahead lets the robot creep backward and drive forward.
TEST(CollisionMonitorComponent, KnowsWhereTheLaserSitsOfARobotWithAPrefix) {
  const std::string back = "robot: {sensors: [{frame: laser, x: 0.0, y: 0.0, theta: 3.14159265}]}\n";
  for (const std::string prefix : {"", "robot1/"}) {
    const auto free_room = [&prefix](double, const Tick& tick) -> std::optional<LaserScan> {
      LaserScan scan = scan_at(tick, 5.0F);
      scan.header().frame_id(prefix + "laser");
      return scan;
    };
    const std::string head = back + (prefix.empty() ? "" : "frame_prefix: " + prefix + "\n");
    const auto v_of = [&](double v) {
      return run(
                 2.0, v,
                 [v](double) {
                   return Twist2{v, 0.0};
                 },
                 free_room, "", -1.0, head)
          .at(1.0)
          .twist.v;
    };
    EXPECT_EQ(v_of(-0.5), -0.5) << prefix;
    EXPECT_LT(v_of(0.5), 0.5) << prefix;
  }
}

// The robot file lists where its sensors sit, and from 1.05 s on scans come from a frame that is not among
// them: 250 ms after the last that is, at 1.0 s, the robot is told to stop. A file that lists none has its
// laser at base_link.
TEST(CollisionMonitorComponent, StopsForScansOfAFrameThatNobodyPlaced) {
  const auto laser = [](double t, const Tick& tick) -> std::optional<LaserScan> {
    LaserScan scan = scan_at(tick, 5.0F);
    if (t > 1.05) scan.header().frame_id("laser_link");
    return scan;
  };
  const Drive drive = run(2.0, 0.8, ahead, laser, "", -1.0, "robot: {sensors: [{frame: laser}]}\n");
  EXPECT_EQ(drive.at(1.24).twist.v, 0.8);
  EXPECT_EQ(drive.at(1.28).twist, Twist2{});
  EXPECT_EQ(drive.states.back().second, "laser_invalid");
  EXPECT_EQ(run(2.0, 0.8, ahead, laser).at(1.9).twist.v, 0.8);
}

TEST(CollisionMonitorComponent, StopsWhenCommandsStopAndThenIsQuiet) {
  const auto wish = [](double t) { return t < 1.05 ? std::optional(Twist2{0.8, 0.0}) : std::nullopt; };
  const Drive drive = run(3.0, 0.0, wish, room);
  EXPECT_EQ(drive.at(1.2).twist.v, 0.8);  // the command of 1.0 s is 200 ms old
  EXPECT_EQ(drive.at(1.22).twist, Twist2{});
  EXPECT_EQ(drive.states.at(drive.states.size() - 1).second, "command_silent");
  EXPECT_LT(drive.commands.at(drive.commands.size() - 2).t, 1.3);  // the last one is that of the end
}

TEST(CollisionMonitorComponent, StopsOnASilentLaserUntilItIsBackForAWhile) {
  const auto laser = [](double t, const Tick& tick) {
    return t < 1.05 || t > 1.95 ? std::optional(scan_at(tick, 5.0F)) : std::nullopt;
  };
  const Drive drive = run(4.0, 0.8, ahead, laser);
  EXPECT_EQ(drive.at(1.24).twist.v, 0.8);
  EXPECT_EQ(drive.at(1.26).twist, Twist2{});
  EXPECT_EQ(drive.at(2.3).twist, Twist2{});  // kClearAfter is 0.4 s
  EXPECT_EQ(drive.at(2.5).twist.v, 0.8);
}

TEST(CollisionMonitorComponent, WithManualResumeItWaitsForTheReset) {
  const auto laser = [](double t, const Tick& tick) {
    return t < 1.05 || t > 1.95 ? std::optional(scan_at(tick, 5.0F)) : std::nullopt;
  };
  const Drive drive = run(5.0, 0.8, ahead, laser, "parameters: {resume: manual}", 4.0);
  EXPECT_EQ(drive.at(3.9).twist, Twist2{});
  EXPECT_EQ(drive.at(4.2).twist.v, 0.8);
}

// The laser fails from 1 to 2 s, while nobody drives: from 0.5 to 3 s. The stop holds until the reset at 4 s
// all the same.
TEST(CollisionMonitorComponent, WithManualResumeAFaultWhileNobodyDrivesWaitsForTheResetToo) {
  const auto laser = [](double t, const Tick& tick) {
    return t < 1.05 || t > 1.95 ? std::optional(scan_at(tick, 5.0F)) : std::nullopt;
  };
  const auto wish = [](double t) {
    return t < 0.55 || t > 2.95 ? std::optional(Twist2{0.8, 0.0}) : std::nullopt;
  };
  const Drive drive = run(5.0, 0.0, wish, laser, "parameters: {resume: manual}", 4.0);
  EXPECT_EQ(drive.at(3.9).twist, Twist2{});
  EXPECT_EQ(drive.at(4.2).twist.v, 0.8);
}

// The planner's last word before the monitor is activated again was a stop, at 1.1 s, while nobody listened.
TEST(CollisionMonitorComponent, ActivatedAgainItPassesNothingOnThatWasSaidBefore) {
  const auto wish = [](double t) -> std::optional<Twist2> {
    if (t > 1.15) return std::nullopt;
    return Twist2{t < 1.05 ? 0.8 : 0.0, 0.0};
  };
  const Drive drive = run(3.0, 0.8, wish, room, "", -1.0, "", {{1.02, "deactivate"}, {1.12, "activate"}});
  EXPECT_EQ(drive.at(1.01).twist.v, 0.8);
  for (const Given& given : drive.commands)
    EXPECT_TRUE(given.t < 1.025 || given.twist == Twist2{}) << given.t;
}

TEST(CollisionMonitorComponent, AFrozenLaserStopsAMovingRobotWithinASecond) {
  for (const double speed : {0.05, 0.8}) {
    const auto laser = [](double t, const Tick& tick) {
      Tick still = tick;
      if (t > 1.05) still.sequence = 10;
      LaserScan scan = scan_at(still, 5.0F);
      scan.header(make_header("laser", tick.now));
      return std::optional(scan);
    };
    const Drive drive = run(3.0, speed, ahead, laser);
    EXPECT_EQ(drive.at(1.1).twist.v, 0.8) << speed;
    EXPECT_EQ(drive.at(2.0).twist, Twist2{}) << speed;
    EXPECT_EQ(drive.states.at(drive.states.size() / 2).second, "laser_frozen") << speed;
  }
}

TEST(CollisionMonitorComponent, UnusableSweepsStopTheRobotAndTenPercentOfThemDoNot) {
  using Spoil = std::function<void(std::vector<float>&)>;
  const auto fill = [](float value) {
    return Spoil([value](std::vector<float>& r) { std::fill(r.begin(), r.end(), value); });
  };
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Spoil> fatal{fill(kNan),
                                 fill(kInfinity),
                                 fill(-kInfinity),
                                 fill(0.0F),
                                 fill(-1.0F),
                                 [](auto& r) { r.resize(kBeams - 20); },
                                 [](auto& r) { r.clear(); },
                                 [](auto& r) { r.resize(1'000'000, 5.0F); }};
  const auto commanded = [](const Spoil& spoil) {
    return run(2.0, 0.8, ahead, [&](double t, const Tick& tick) {
      LaserScan scan = scan_at(tick, 5.0F);
      if (t > 1.05) spoil(scan.ranges());
      return std::optional(scan);
    });
  };
  for (std::size_t i = 0; i < fatal.size(); ++i) {
    const Drive drive = commanded(fatal[i]);
    EXPECT_EQ(drive.at(1.04).twist.v, 0.8) << i;
    EXPECT_EQ(drive.at(1.32).twist, Twist2{}) << i;
  }
  const Drive drive = commanded([](auto& r) {
    for (std::size_t i = 0; i < r.size(); i += 10) r[i] = kNan;
  });
  EXPECT_EQ(drive.at(1.9).twist.v, 0.8);
}

TEST(CollisionMonitorComponent, ASweepThatClaimsABillionBeamsIsNotRead) {
  LaserScan scan = scan_at({}, 5.0F);
  scan.ranges({1.0F, 2.0F, 3.0F});
  std::vector<std::uint8_t> cdr;
  serialize(scan, cdr);
  const std::uint32_t three = 3;
  const float first = 1.0F;
  std::array<std::uint8_t, 8> mark{};  // length, then the first range
  std::memcpy(mark.data(), &three, 4);
  std::memcpy(mark.data() + 4, &first, 4);
  const auto found = std::search(cdr.begin(), cdr.end(), mark.begin(), mark.end());
  ASSERT_NE(found, cdr.end());
  LaserScan read;
  ASSERT_TRUE(deserialize(cdr, read));
  const std::uint32_t billion = 1'000'000'000;
  std::memcpy(&*found, &billion, 4);
  EXPECT_FALSE(deserialize(cdr, read));
}

}  // namespace
}  // namespace bw
