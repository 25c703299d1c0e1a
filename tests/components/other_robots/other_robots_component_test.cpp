// The other robots on their topics: a script plays the people tracker, the transforms and the other robot.
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <gtest/gtest.h>
#include <nav_msgs/msg/odometry.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/geometry.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::Track;
using bandwagon_msgs::msg::Tracks;
using nav_msgs::msg::Odometry;
using sensor_msgs::msg::LaserScan;

constexpr std::uint32_t kFirstRobot = 2'000'000'000;

/// What was published at t [s]; nothing before the first.
struct Seen {
  std::vector<std::pair<double, Tracks>> tracks;

  std::vector<std::uint32_t> ids_at(double t) const {
    std::vector<std::uint32_t> ids;
    for (const auto& [time, message] : tracks) {
      if (time > t + 1e-9) break;
      ids.clear();
      for (const Track& track : message.tracks()) ids.push_back(track.id());
    }
    return ids;
  }
};

Track track_at(std::uint32_t id, double x, double y) {
  Track track;
  track.confidence(1.0);
  track.id(id);
  track.position(to_point({x, y}));
  track.radius(0.3);
  return track;
}

/// A disc of 0.3 m straight ahead, and nothing else.
LaserScan scan_of_disc_at(double x, Time now) {
  constexpr int kBeams = 721;
  LaserScan scan;
  scan.header(make_header("robot1/laser", now));
  scan.angle_min(-1.5F);
  scan.angle_max(1.5F);
  scan.angle_increment(3.0F / (kBeams - 1));
  scan.range_min(0.05F);
  scan.range_max(20.0F);
  std::vector<float> ranges;
  for (int i = 0; i < kBeams; ++i) {
    const double angle = -1.5 + 3.0 * i / (kBeams - 1);
    const double across = x * std::sin(angle);
    const bool is_hit = std::abs(across) < 0.3 && std::cos(angle) > 0.0;
    ranges.push_back(is_hit ? static_cast<float>(x * std::cos(angle) - std::sqrt(0.09 - across * across))
                            : std::numeric_limits<float>::infinity());
  }
  scan.ranges(std::move(ranges));
  return scan;
}

/// odom lies at (1, 0) of map. In odom the other robot drives at (4 + 0.5 t, 0); the laser takes it for
/// somebody (3) 0.2 m before its middle, and sees a person (4) who touches it from the side. 50 Hz, tracks at
/// 10 Hz.
Seen run(const std::string& parameters, const std::function<void(double t, Odometry&)>& change = {},
         double silent_from = 1e9, bool with_laser = false) {
  Seen seen;
  const std::string graph =
      "frame_prefix: robot1/\ncomponents: {other_robots: {parameters: " + parameters + "}}";
  run_with_script(graph, 3.0, [&](Setup& setup) {
    setup.input<Tracks>("tracks", Qos::standard(50), [&](const Tracks& message, const Tick& tick) {
      seen.tracks.emplace_back(seconds_since_start(tick.now), message);
    });
    setup.every(Duration::milliseconds(20), "other robot",
                [=, tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf()),
                 out = setup.output<Odometry>("/robot2/odometry/filtered")](const Tick& tick) {
                  const double t = seconds_since_start(tick.now);
                  tf2_msgs::msg::TFMessage transforms;
                  transforms.transforms() = {
                      to_transform("map", "robot1/odom", tick.now, Pose2{1.0, 0.0, 0.0}),
                      to_transform("robot1/odom", "robot1/laser", tick.now, Pose2{})};
                  tf.publish(transforms);
                  if (t > silent_from) return;
                  Odometry odometry;
                  odometry.header(make_header("map", tick.now));
                  odometry.child_frame_id("robot2/base_link");
                  odometry.pose().pose(to_pose({5.0 + 0.5 * t, 0.0, 0.0}));
                  odometry.twist().twist(to_twist_message({0.5, 0.0}));
                  if (change) change(t, odometry);
                  out.publish(odometry);
                });
    setup.every(Duration::milliseconds(100), "people",
                [=, out = setup.output<Tracks>("people_tracks"),
                 scans = setup.output<LaserScan>("scan")](const Tick& tick) {
                  const double x = 4.0 + 0.5 * seconds_since_start(tick.now);
                  if (with_laser) scans.publish(scan_of_disc_at(x, tick.now));
                  Tracks people;
                  people.header(make_header("robot1/odom", tick.now));
                  people.tracks() = {track_at(3, x - 0.2, 0.05), track_at(4, x, 0.6)};
                  out.publish(people);
                });
  });
  return seen;
}

using Ids = std::vector<std::uint32_t>;

TEST(OtherRobots, TheirOwnWordTakesThePlaceOfWhatTheLaserSeesOfThem) {
  const Seen seen = run("{robots: [/robot2]}");
  EXPECT_EQ(seen.ids_at(1.0), (Ids{4, kFirstRobot}));
  const auto& [t, message] = seen.tracks.back();
  EXPECT_EQ(message.header().frame_id(), "robot1/odom");
  const Track& robot = message.tracks().back();
  EXPECT_NEAR(robot.position().x(), 4.0 + 0.5 * t,
              0.011);  // 20 ms of its path, the newest message may be of before
  EXPECT_NEAR(robot.velocity().x(), 0.5, 1e-9);
  EXPECT_EQ(robot.radius(), 0.3);  // that of the robot itself
  ASSERT_EQ(robot.predictions().size(), 8U);
  EXPECT_NEAR(robot.predictions().back().x(), robot.position().x() + 4.0 * 0.5, 1e-6);
}

TEST(OtherRobots, OfASilentOneTheLaserTellsAgain) {
  const Seen seen = run("{robots: [/robot2], timeout: 0.5}", {}, 1.0);
  EXPECT_EQ(seen.ids_at(1.4), (Ids{4, kFirstRobot}));
  EXPECT_EQ(seen.ids_at(1.7), (Ids{3, 4}));
}

TEST(OtherRobots, ASilentOneIsFollowedByTheLaserFromItsLastWordOn) {
  const Seen seen = run("{robots: [/robot2], timeout: 0.5}", {}, 1.0, true);
  EXPECT_EQ(seen.ids_at(2.8), (Ids{4, kFirstRobot}));
  const auto& [t, message] = seen.tracks.back();
  const Track& robot = message.tracks().back();
  EXPECT_NEAR(robot.position().x(), 4.0 + 0.5 * t, 0.1);
  EXPECT_NEAR(robot.velocity().x(), 0.5, 0.1);
}

TEST(OtherRobots, ABadWordIsNoneAndASoundOneCountsAgain) {
  const std::vector<std::function<void(Odometry&)>> faults = {
      [](Odometry& m) { m.pose().pose().position().x(std::numeric_limits<double>::quiet_NaN()); },
      [](Odometry& m) { m.twist().twist().linear().x(std::numeric_limits<double>::infinity()); },
      [](Odometry& m) { m.pose().pose().orientation().w(0.0); },
      [](Odometry& m) { m.header().frame_id("robot2/odom"); },
      [](Odometry& m) {
        m.header().stamp(to_stamp(from_stamp(m.header().stamp()) + Duration::milliseconds(700)));
      },
      [](Odometry& m) { m.pose().covariance()[0] = 1.0; }};
  for (std::size_t i = 0; i < faults.size(); ++i) {
    const Seen seen = run("{robots: [/robot2]}", [&](double t, Odometry& m) {
      if (t < 1.5) faults[i](m);
    });
    EXPECT_EQ(seen.ids_at(1.0), (Ids{3, 4})) << "fault " << i;
    EXPECT_EQ(seen.ids_at(2.0), (Ids{4, kFirstRobot})) << "fault " << i;
  }
}

TEST(OtherRobots, TheRobotItselfIsNoOther) {
  const Seen seen =
      run("{robots: [/robot2]}", [](double, Odometry& m) { m.child_frame_id("robot1/base_link"); });
  EXPECT_EQ(seen.ids_at(2.0), (Ids{3, 4}));
}

}  // namespace
}  // namespace bw
