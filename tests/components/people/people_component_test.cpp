// The people component on its topics: the simulated laser of a driving robot in, tracks out; and scans that
// are none.
#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/ground_truth.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <gtest/gtest.h>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <people_msgs/msg/people.hpp>
#include <sensor_msgs/msg/joint_state.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/wheel_joints.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::GroundTruth;
using bandwagon_msgs::msg::Tracks;

struct Seen {
  std::vector<Tracks> tracks;
  std::map<std::int64_t, GroundTruth> truths;  ///< by stamp
  people_msgs::msg::People people;
  visualization_msgs::msg::MarkerArray people_markers;
  visualization_msgs::msg::MarkerArray leg_markers;
};

/// A room with two walkers and somebody who stands; the laser sits 0.2 m before the wheels, half a turn
/// round.
const char* const kRoom = R"(
robot: {sensors: [{frame: laser, x: 0.2, y: 0.05, theta: 0.5}]}
components:
  world:
    parameters:
      start: {x: 1.0, y: 0.0, theta: 0.0}
      walls:
        - {x1: -1.0, y1: -3.0, x2: 12.0, y2: -3.0}
        - {x1: -1.0, y1: 3.0, x2: 12.0, y2: 3.0}
        - {x1: 12.0, y1: -3.0, x2: 12.0, y2: 3.0}
        - {x1: -1.0, y1: -3.0, x2: -1.0, y2: 3.0}
      drive: {mismatch: 0.004, noise: 0.00003}
      people:
        scripted:
          - {waypoints: [{x: 4.0, y: 1.5}], speed: 1.0}
          - {waypoints: [{x: 8.0, y: -1.5}, {x: 4.0, y: -1.5}], speed: 0.8, turn_round: true}
          - {waypoints: [{x: 6.0, y: 2.0}, {x: 6.0, y: -0.5}], speed: 1.1, turn_round: true}
  robot_base: {}
  people: {}
)";

Seen run_in_room(double seconds) {
  Seen seen;
  run_with_script(kRoom, seconds, [&](Setup& setup) {
    setup.input<Tracks>("tracks", Qos::standard(50),
                        [&](const Tracks& m, const Tick&) { seen.tracks.push_back(m); });
    setup.input<GroundTruth>("sim/ground_truth", Qos::standard(50), [&](const GroundTruth& m, const Tick&) {
      seen.truths[from_stamp(m.header().stamp()).nanoseconds] = m;
    });
    setup.input<people_msgs::msg::People>("people", Qos::standard(),
                                          [&](const auto& m, const Tick&) { seen.people = m; });
    setup.input<visualization_msgs::msg::MarkerArray>(
        "people_markers", Qos::standard(), [&](const auto& m, const Tick&) { seen.people_markers = m; });
    setup.input<visualization_msgs::msg::MarkerArray>(
        "leg_detections", Qos::standard(), [&](const auto& m, const Tick&) { seen.leg_markers = m; });
    setup.every(Duration::milliseconds(50), "drive",
                [wheels = setup.command<sensor_msgs::msg::JointState>("wheel_commands")](const Tick& tick) {
                  // A gentle arc.
                  wheels.publish(to_joint_state({0.24, 0.26}, {0.0762, 0.0762}, tick.now));
                });
  });
  return seen;
}

TEST(PeopleComponent, TracksEverybodyFromADrivingRobot) {
  const Seen seen = run_in_room(6.0);
  ASSERT_GT(seen.tracks.size(), 55U);  // 10 Hz
  const Pose2 X_MO{1.0, 0.0, 0.0};     // where the odometry started
  int expected = 0;
  int found = 0;
  int reported = 0;
  int right = 0;
  for (const Tracks& message : seen.tracks) {
    EXPECT_EQ(message.header().frame_id(), "odom");
    const Time stamp = from_stamp(message.header().stamp());
    if (seconds_since_start(stamp) < 2.0) continue;
    const auto truth = seen.truths.find(stamp.nanoseconds);
    if (truth == seen.truths.end()) continue;
    for (const auto& person : truth->second.people()) {
      ++expected;
      for (const auto& track : message.tracks()) {
        const Vector2 p_M = X_MO * Vector2(track.position().x(), track.position().y());
        if ((p_M - Vector2(person.position().x(), person.position().y())).norm() > 0.3) continue;
        ++found;
        break;
      }
    }
    for (const auto& track : message.tracks()) {
      ++reported;
      const Vector2 p_M = X_MO * Vector2(track.position().x(), track.position().y());
      for (const auto& person : truth->second.people()) {
        if ((p_M - Vector2(person.position().x(), person.position().y())).norm() > 0.3) continue;
        ++right;
        break;
      }
    }
  }
  ASSERT_GT(expected, 100);
  // One of the three may walk behind another for half a second.
  EXPECT_GT(found, 0.9 * expected);
  EXPECT_GT(right, 0.95 * reported);

  ASSERT_FALSE(seen.tracks.back().tracks().empty());
  const auto& track = seen.tracks.back().tracks()[0];
  EXPECT_EQ(track.predictions().size(), 8U);  // 4 s in steps of 0.5 s
  EXPECT_GT(track.covariance()[0], 0.0);
  EXPECT_GT(track.covariance()[10], 0.0);
  EXPECT_EQ(seen.people.people().size(), seen.tracks.back().tracks().size());
  EXPECT_GE(seen.people_markers.markers().size(), seen.people.people().size());
  EXPECT_GE(seen.leg_markers.markers().size(), 3U);
}

TEST(PeopleComponent, SameSeedSameTracks) {
  const Seen a = run_in_room(3.0);
  const Seen b = run_in_room(3.0);
  ASSERT_EQ(a.tracks.size(), b.tracks.size());
  for (std::size_t i = 0; i < a.tracks.size(); ++i) EXPECT_EQ(a.tracks[i], b.tracks[i]) << i;
}

sensor_msgs::msg::LaserScan sound_scan(Time stamp) {
  sensor_msgs::msg::LaserScan scan;
  scan.header(make_header("laser", stamp));
  scan.angle_min(-1.0F);
  scan.angle_max(1.0F);
  scan.angle_increment(0.01F);
  scan.range_min(0.05F);
  scan.range_max(10.0F);
  scan.ranges(std::vector<float>(201, 5.0F));
  return scan;
}

using Break = std::function<void(sensor_msgs::msg::LaserScan&)>;

/// Sound scans for 1 s, broken ones for 1 s, sound ones for 1 s; the times of tracks that came.
std::vector<double> times_of_tracks(const Break& break_scan) {
  std::vector<double> times;
  run_with_script("components: {people: {}}", 3.05, [&](Setup& setup) {
    setup.input<Tracks>("tracks", Qos::standard(50), [&](const Tracks& m, const Tick&) {
      times.push_back(seconds_since_start(from_stamp(m.header().stamp())));
    });
    setup.every(Duration::milliseconds(50), "sensors",
                [&break_scan, scan = setup.output<sensor_msgs::msg::LaserScan>("scan", Qos::sensor()),
                 odom = setup.output<nav_msgs::msg::Odometry>("odom")](const Tick& tick) {
                  nav_msgs::msg::Odometry odometry;
                  odometry.header(make_header("odom", tick.now));
                  odometry.pose().pose(to_pose(Pose2{}));
                  odom.publish(odometry);
                  if (tick.sequence % 2 == 0) return;
                  sensor_msgs::msg::LaserScan message = sound_scan(tick.now);
                  const double t = seconds_since_start(tick.now);
                  if (t > 1.01 && t < 2.01) break_scan(message);
                  scan.publish(message);
                });
  });
  return times;
}

int count_between(const std::vector<double>& times, double from, double to) {
  return static_cast<int>(
      std::count_if(times.begin(), times.end(), [&](double t) { return t > from && t < to; }));
}

TEST(PeopleComponent, ScansThatAreNoneGiveNoTracksAndSoundOnesDoAgain) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::map<std::string, Break> breaks = {
      {"no ranges", [](auto& s) { s.ranges().clear(); }},
      {"half the ranges", [](auto& s) { s.ranges().resize(100); }},
      {"too many ranges", [](auto& s) { s.ranges().resize(100'000, 1.0F); }},
      {"increment NaN", [&](auto& s) { s.angle_increment(nan); }},
      {"increment zero", [](auto& s) { s.angle_increment(0.0F); }},
      {"angle infinite", [](auto& s) { s.angle_min(std::numeric_limits<float>::infinity()); }},
      {"limits swapped", [](auto& s) { s.range_max(0.01F); }},
      {"stamp an hour ahead", [](auto& s) { s.header().stamp().sec(s.header().stamp().sec() + 3600); }},
      {"stamp zero", [](auto& s) { s.header().stamp({}); }}};
  for (const auto& [name, break_scan] : breaks) {
    const std::vector<double> times = times_of_tracks(break_scan);
    EXPECT_GE(count_between(times, 0.0, 1.01), 9) << name;
    EXPECT_EQ(count_between(times, 1.01, 2.01), 0) << name;
    EXPECT_GE(count_between(times, 2.01, 3.1), 9) << name;
    EXPECT_EQ(count_between(times, -1e9, 0.0) + count_between(times, 3.1, 1e9), 0) << name;
  }
}

TEST(PeopleComponent, BeamsThatSayNothingAreNoScanAndAnEmptyHallIsOne) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinity = std::numeric_limits<float>::infinity();
  const auto looked_at = [](float value, std::size_t share) {
    return count_between(times_of_tracks([&](auto& s) {
                           for (std::size_t i = 0; i < s.ranges().size(); i += share) s.ranges()[i] = value;
                         }),
                         1.01, 2.01);
  };
  for (const float value : {nan, -infinity, 0.0F, -3.0F, 1e30F}) {
    EXPECT_EQ(looked_at(value, 1), 0) << value;
    EXPECT_EQ(looked_at(value, 10), 10) << value;  // every tenth beam lost
  }
  EXPECT_EQ(looked_at(infinity, 1), 10);
}

}  // namespace
}  // namespace bw
