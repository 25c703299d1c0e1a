// SLAM on its topics, in lock-step: a robot goes round a room twice, with odometry that is 3 % short and turns too far.
#include <cmath>
#include <numbers>
#include <vector>

#include <bandwagon_msgs/msg/tracks.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <nav_msgs/srv/get_map.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <slam_toolbox/srv/pause.hpp>
#include <slam_toolbox/srv/reset.hpp>
#include <slam_toolbox/srv/save_map.hpp>
#include <tf2_msgs/msg/tf_message.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/files/map_file.hpp"
#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/map_input.hpp"
#include "tests/components/service_calls.hpp"
#include "tests/components/slam/slam_room.hpp"

namespace bw {
namespace {

using namespace slam::test;

using nav_msgs::srv::GetMap;
using sensor_msgs::msg::LaserScan;
using slam_toolbox::srv::Pause;
using slam_toolbox::srv::Reset;
using slam_toolbox::srv::SaveMap;

struct Seen {
  std::vector<nav_msgs::msg::OccupancyGrid> maps;
  std::vector<map_msgs::msg::OccupancyGridUpdate> updates;
  OccupancyGrid followed;  ///< the map, and updates laid into it
  std::vector<visualization_msgs::msg::MarkerArray> graphs;
  std::vector<nav_msgs::msg::Odometry> poses;  ///< odometry/filtered
  std::vector<Pose2> X_MO;
  std::vector<GetMap::Response> shown;
  std::vector<SaveMap::Response> saved;
  std::vector<Pause::Response> paused;
  std::vector<Reset::Response> reset;
};

struct Script {
  std::string parameters;
  std::vector<TimedRequest<SaveMap>> saves;
  std::vector<TimedRequest<Pause>> pauses;
  std::vector<TimedRequest<Reset>> resets;
  double seconds = 40.0;
  double scan_delay = 0.0;  ///< [s] by which odometry comes later than scans
  bool person = false;
  bool tracked = false;  ///< and `tracks` tells
};

Seen run(const Script& script) {
  Seen seen;
  const std::string yaml = "components: {slam: {parameters: {" + script.parameters + "}}}";
  run_with_script(yaml, script.seconds, [&](Setup& setup) {
    listen_to_map(setup, [&](const KnownMap& m, const Tick&) { seen.followed = m.grid; });
    setup.input<nav_msgs::msg::OccupancyGrid>("map", Qos::latched(),
                                              [&](const auto& m, const Tick&) { seen.maps.push_back(m); });
    setup.input<map_msgs::msg::OccupancyGridUpdate>(
        "map_updates", Qos::standard(), [&](const auto& m, const Tick&) { seen.updates.push_back(m); });
    setup.input<visualization_msgs::msg::MarkerArray>(
        "slam_toolbox/graph_visualization", Qos::latched(),
        [&](const auto& m, const Tick&) { seen.graphs.push_back(m); });
    setup.input<nav_msgs::msg::Odometry>("odometry/filtered", Qos::standard(50),
                                         [&](const auto& m, const Tick&) { seen.poses.push_back(m); });
    setup.input<tf2_msgs::msg::TFMessage>("/tf", Qos::tf(), [&](const auto& m, const Tick&) {
      for (const auto& transform : m.transforms())
        if (transform.child_frame_id() == "odom")
          seen.X_MO.push_back({transform.transform().translation().x(),
                               transform.transform().translation().y(),
                               yaw_of(transform.transform().rotation())});
    });
    call_at<SaveMap>(setup, "slam_toolbox/save_map", script.saves, seen.saved);
    call_at<Pause>(setup, "slam_toolbox/pause_new_measurements", script.pauses, seen.paused);
    call_at<Reset>(setup, "slam_toolbox/reset", script.resets, seen.reset);
    call_at<GetMap>(setup, "slam_toolbox/dynamic_map", {{script.seconds - 0.5, {}}}, seen.shown);
    setup.every(
        Duration::milliseconds(20), "robot",
        [&script, scan = setup.output<LaserScan>("scan", Qos::sensor()),
         tracks = setup.output<bandwagon_msgs::msg::Tracks>("tracks"),
         tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf()),
         odom = setup.output<nav_msgs::msg::Odometry>("odom"),
         tf_static = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched())](const Tick& tick) {
          const double t = seconds_since_start(tick.now);
          if (tick.sequence == 0) {
            tf2_msgs::msg::TFMessage mounts;
            mounts.transforms().push_back(to_transform("base_link", "laser", tick.now, kMount));
            tf_static.publish(mounts);
          }
          // Who is tracked is so from before the first scan.
          if (tick.sequence % 5 == 0 && (!script.tracked || tick.sequence > 5))
            scan.publish(room_scan(truth_at(t), tick.now, script.person));
          const double late = t - script.scan_delay;
          if (late < 0.0) return;
          nav_msgs::msg::Odometry message;
          message.header(make_header("odom", tick.now - Duration::seconds(script.scan_delay)));
          message.child_frame_id("base_link");
          message.pose().pose(to_pose(odometry_at(late)));
          odom.publish(message);
          if (!script.tracked) return;
          tf2_msgs::msg::TFMessage transform;
          transform.transforms().push_back(to_transform("odom", "base_link", tick.now, odometry_at(late)));
          tf.publish(transform);
          bandwagon_msgs::msg::Tracks people;
          people.header(make_header("base_link", tick.now));
          bandwagon_msgs::msg::Track track;
          const Vector2 at = inverse(truth_at(t)) * kPerson.center;
          track.position().x(at.x());
          track.position().y(at.y());
          track.radius(kPerson.radius);
          track.confidence(1.0);
          people.tracks().push_back(track);
          tracks.publish(people);
        });
  });
  return seen;
}

Pose2 last_pose(const Seen& seen) { return from_pose(seen.poses.back().pose().pose()); }
double time_of_last(const Seen& seen) {
  return seconds_since_start(from_stamp(seen.poses.back().header().stamp()));
}

OccupancyGrid grid_of(const nav_msgs::msg::OccupancyGrid& message) {
  OccupancyGrid grid;
  EXPECT_EQ(read_grid(message, grid), "");
  return grid;
}

SaveMap::Request save(const std::string& name) {
  SaveMap::Request request;
  request.name().data(name);
  return request;
}

// Truth: the circle that the script drives. After 40 s odometry alone is off by a third of a metre.
TEST(SlamComponent, KnowsWhereTheRobotIsWhereOdometryDoesNot) {
  const Seen seen = run({});
  ASSERT_GT(seen.poses.size(), 1500U);  // 50 a second
  const double t = time_of_last(seen);
  const Pose2 X_MB = last_pose(seen);
  const Pose2 truth = truth_at(t);
  EXPECT_GT((odometry_at(t).position() - truth.position()).norm(), 0.3);
  EXPECT_LT((X_MB.position() - truth.position()).norm(), 0.03);
  EXPECT_LT(std::abs(wrap_angle(X_MB.theta - truth.theta)), 0.01);
}

// 0.02 m and 0.5 degrees: what a local planner does not notice.
TEST(SlamComponent, MovesMapToOdomInSmallSteps) {
  const Seen seen = run({});
  ASSERT_GT(seen.X_MO.size(), 1500U);
  for (std::size_t i = 1; i < seen.X_MO.size(); ++i) {
    const double t = 0.02 * static_cast<double>(i);
    const Pose2 a = seen.X_MO[i - 1] * odometry_at(t);
    const Pose2 b = seen.X_MO[i] * odometry_at(t);
    ASSERT_LE((a.position() - b.position()).norm(), 0.02) << i;
    ASSERT_LE(std::abs(wrap_angle(a.theta - b.theta)), 0.0088) << i;
  }
}

// The room's own walls, within a cell and a half of where they stand.
TEST(SlamComponent, PublishesAMapThatGrowsToTheRoom) {
  const Seen seen = run({});
  ASSERT_GE(seen.maps.size(), 5U);
  const OccupancyGrid grid = grid_of(seen.maps.back());
  int walls = 0;
  int free = 0;
  for (int row = 0; row < grid.height; ++row) {
    for (int column = 0; column < grid.width; ++column) {
      const Vector2 p = grid.center(column, row);
      if (grid.at(column, row) == OccupancyGrid::kFree) ++free;
      if (grid.at(column, row) != OccupancyGrid::kOccupied) continue;
      ++walls;
      double nearest = 1e9;
      for (const Segment& wall : kRoom) {
        const Vector2 along = wall.b - wall.a;
        const double s = std::clamp((p - wall.a).dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest = std::min(nearest, (p - wall.a - s * along).norm());
      }
      EXPECT_LT(nearest, 0.075) << p.transpose();
    }
  }
  EXPECT_GT(walls, 400);                       // 28 m of wall in cells of 5 cm, most of it seen
  EXPECT_NEAR(free * 0.05 * 0.05, 45.0, 3.0);  // 48 m^2 less cupboards of 2 and 0.7 m^2
  ASSERT_EQ(seen.shown.size(), 1U);
  EXPECT_EQ(seen.shown[0].map().info().width(), seen.maps.back().info().width());
}

// In 34 s of 2 s each, with the room seen from the first scan on: whole maps when the size changes and every
// tenth second, updates between. Whoever lays these into those has at every time what is asked for by service.
TEST(SlamComponent, UpdatesBetweenMapsAreThoseThatChanged) {
  const Seen seen = run({.pauses = {{34.0, {}}}});
  EXPECT_GE(seen.maps.size(), 3U);
  EXPECT_LE(seen.maps.size(), 8U);
  EXPECT_GE(seen.updates.size(), 8U);
  ASSERT_EQ(seen.shown.size(), 1U);
  EXPECT_EQ(seen.followed.cells, seen.shown[0].map().data());
  EXPECT_EQ(seen.followed.origin, grid_of(seen.shown[0].map()).origin);
  EXPECT_EQ(seen.maps.back().data(), seen.followed.cells)
      << "four seconds after the last change it is told whole";
}

// Round the room more than twice, 2 m from submap to submap at 9.4 m a round: a sphere on the circle for each,
// a line from each to the next, and loops, none of them taken back (red); told only when it changed.
TEST(SlamComponent, ShowsItsGraphWhenItChanged) {
  const Seen seen = run({.pauses = {{35.0, {}}}});
  ASSERT_GE(seen.graphs.size(), 3U);
  EXPECT_LE(seen.graphs.size(), 18U) << "an interval in which nothing changed tells nothing";
  const auto& markers = seen.graphs.back().markers();
  ASSERT_EQ(markers.size(), 4U);
  namespace constants = visualization_msgs::msg::Marker_Constants;
  EXPECT_EQ(markers[0].action(), constants::DELETEALL);
  EXPECT_EQ(markers[1].type(), constants::SPHERE_LIST);
  const std::size_t nodes = markers[1].points().size();
  EXPECT_GE(nodes, 5U);
  for (const auto& point : markers[1].points())
    EXPECT_NEAR(std::hypot(point.x(), point.y() - kRadius), kRadius, 0.05);
  EXPECT_EQ(markers[2].type(), constants::LINE_LIST);
  EXPECT_EQ(markers[2].points().size(), 2 * (nodes - 1));
  EXPECT_EQ(markers[3].type(), constants::LINE_LIST);
  EXPECT_GE(markers[3].points().size(), 2U);
  ASSERT_EQ(markers[3].colors().size(), markers[3].points().size());
  for (const auto& color : markers[3].colors()) EXPECT_GE(color.g(), 0.6F) << "green to amber";
}

int occupied_near(const OccupancyGrid& grid, const Disc& disc) {
  int cells = 0;
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column)
      if (grid.at(column, row) == OccupancyGrid::kOccupied &&
          (grid.center(column, row) - disc.center).norm() < disc.radius + 0.1)
        ++cells;
  return cells;
}

// Who stands there for the whole drive is a wall, but not if `tracks` knows better.
TEST(SlamComponent, LeavesPeopleOutOfTheMap) {
  const Seen taken_for_a_wall = run({.seconds = 20.0, .person = true});
  const Seen known = run({.seconds = 20.0, .person = true, .tracked = true});
  ASSERT_FALSE(taken_for_a_wall.maps.empty());
  ASSERT_FALSE(known.maps.empty());
  EXPECT_GT(occupied_near(grid_of(taken_for_a_wall.maps.back()), kPerson), 10);
  EXPECT_EQ(occupied_near(grid_of(known.maps.back()), kPerson), 0);
}

TEST(SlamComponent, StartsWhereItIsToldTo) {
  const Seen seen = run({.parameters = "map_start_pose: {x: 10.0, y: -3.0, yaw: 1.5}", .seconds = 5.0});
  const Pose2 truth = Pose2{10.0, -3.0, 1.5} * truth_at(time_of_last(seen));
  EXPECT_LT((last_pose(seen).position() - truth.position()).norm(), 0.03);
}

// Odometry half a second behind the scans: they wait for it, and the pose is as good.
TEST(SlamComponent, WaitsForOdometryOfAScansTime) {
  const Seen seen = run({.seconds = 20.0, .scan_delay = 0.5});
  EXPECT_LT((last_pose(seen).position() - truth_at(time_of_last(seen)).position()).norm(), 0.05);
}

TEST(SlamComponent, SavesItsMapAsMapServerReadsIt) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("slam_maps_" + std::to_string(getpid()));
  std::filesystem::create_directory(folder);
  const Seen seen = run(
      {.parameters = "folder: " + folder.string(),
       .saves = {{0.01, save("early")}, {20.0, save("room")}, {21.0, save("room")}, {22.0, save("../out")}},
       .seconds = 25.0});
  namespace result = slam_toolbox::srv::SaveMap_Response_Constants;
  ASSERT_EQ(seen.saved.size(), 4U);
  EXPECT_EQ(seen.saved[0].result(), result::RESULT_NO_MAP_RECEIEVD);
  EXPECT_EQ(seen.saved[1].result(), result::RESULT_SUCCESS);
  EXPECT_EQ(seen.saved[2].result(), result::RESULT_UNDEFINED_FAILURE);  // it is there
  EXPECT_EQ(seen.saved[3].result(), result::RESULT_UNDEFINED_FAILURE);  // a way out of the folder
  const OccupancyGrid grid = load_map(folder / "room.yaml");
  EXPECT_GT(grid.width * 0.05, 8.0);
  EXPECT_FALSE(std::filesystem::exists(folder / "early.yaml"));
  std::filesystem::remove_all(folder);
}

TEST(SlamComponent, PausesAndBeginsAnew) {
  Reset::Request paused;
  paused.pause_new_measurements(true);
  const Seen seen = run({.pauses = {{10.0, {}}, {12.0, {}}}, .resets = {{15.0, paused}}, .seconds = 20.0});
  ASSERT_EQ(seen.paused.size(), 2U);
  EXPECT_TRUE(seen.paused[0].status());
  ASSERT_EQ(seen.reset.size(), 1U);
  // Nothing is told of a map that has no scan.
  EXPECT_LT(time_of_last(seen), 15.1);
  ASSERT_EQ(seen.shown.size(), 1U);
  EXPECT_EQ(seen.shown[0].map().info().width(), 0U);
}

TEST(SlamComponent, TellsTheSameTwice) {
  const Seen a = run({.seconds = 15.0});
  const Seen b = run({.seconds = 15.0});
  ASSERT_EQ(a.X_MO.size(), b.X_MO.size());
  for (std::size_t i = 0; i < a.X_MO.size(); ++i) ASSERT_EQ(a.X_MO[i], b.X_MO[i]) << i;
  ASSERT_EQ(a.maps.size(), b.maps.size());
  EXPECT_EQ(a.maps.back().data(), b.maps.back().data());
}

}  // namespace
}  // namespace bw
