// The services of the local costmap: a robot stands before a wall at x = 1.43 m and looks at it ten times in
// the first second; then only the costmap remembers it.
#include <limits>

#include <bandwagon_msgs/msg/obstacles.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <geometry_msgs/msg/polygon_stamped.hpp>
#include <gtest/gtest.h>
#include <nav2_msgs/srv/clear_costmap_around_robot.hpp>
#include <nav2_msgs/srv/clear_costmap_except_region.hpp>
#include <nav2_msgs/srv/clear_entire_costmap.hpp>
#include <nav2_msgs/srv/get_costmap.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/costmap.hpp"
#include "components/model/cell_cost.hpp"
#include "components/world/ray.hpp"
#include "tests/components/service_calls.hpp"

namespace bw {
namespace {

using nav2_msgs::srv::ClearCostmapAroundRobot;
using nav2_msgs::srv::ClearCostmapExceptRegion;
using nav2_msgs::srv::ClearEntireCostmap;
using nav2_msgs::srv::GetCostmap;

const Pose2 kX_OB{0.7, -0.4, 0.3};
const Segment kNearWall{{1.43, -20.0}, {1.43, 20.0}};

sensor_msgs::msg::LaserScan sweep(Time now) {
  sensor_msgs::msg::LaserScan scan;
  scan.header(make_header("base_link", now));
  scan.angle_min(-2.35F);
  scan.angle_increment(4.7F / 719.0F);
  scan.angle_max(2.35F);
  scan.range_min(0.05F);
  scan.range_max(20.0F);
  for (int i = 0; i < 720; ++i) {
    const Vector2 unit = direction(kX_OB.theta - 2.35 + 4.7 / 719.0 * i);
    scan.ranges().push_back(static_cast<float>(ray_hit(kX_OB.position(), unit, kNearWall)));
  }
  return scan;
}

/// Costmaps asked for at 1.3, 1.5, ... s.
std::vector<nav2_msgs::msg::Costmap> costmaps(std::size_t count, const std::function<void(Setup&)>& clear,
                                              const std::string& parameters = "decay_time: 100.0") {
  std::vector<GetCostmap::Response> responses;
  run_with_script(
      "components: {local_costmap: {parameters: {" + parameters + "}}}", 3.0, [&](bw::Setup& setup) {
        setup.input<bandwagon_msgs::msg::Obstacles>("obstacles", Qos::standard(),
                                                    [](const auto&, const Tick&) {});
        setup.every(Duration::milliseconds(50), "robot",
                    [scan = setup.output<sensor_msgs::msg::LaserScan>("scan", Qos::sensor()),
                     tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf()),
                     tf_static = setup.output<tf2_msgs::msg::TFMessage>("/tf_static", Qos::latched())](
                        const Tick& tick) {
                      tf2_msgs::msg::TFMessage message;
                      message.transforms().push_back(to_transform("odom", "base_link", tick.now, kX_OB));
                      tf.publish(message);
                      if (tick.sequence % 2 == 0 && seconds_since_start(tick.now) < 1.0)
                        scan.publish(sweep(tick.now));
                    });
        std::vector<TimedRequest<GetCostmap>> requests;
        for (std::size_t i = 0; i < count; ++i) requests.push_back({1.3 + 0.2 * static_cast<double>(i)});
        call_at<GetCostmap>(setup, "local_costmap/get_costmap", requests, responses);
        clear(setup);
      });
  std::vector<nav2_msgs::msg::Costmap> maps;
  for (const auto& response : responses) maps.push_back(response.map());
  EXPECT_EQ(maps.size(), count);
  return maps;
}

int cost_at(const nav2_msgs::msg::Costmap& map, const Vector2& p) {
  const double resolution = static_cast<double>(map.metadata().resolution());
  const Pose2 origin = from_pose(map.metadata().origin());
  const auto column = static_cast<std::size_t>((p.x() - origin.x) / resolution);
  const auto row = static_cast<std::size_t>((p.y() - origin.y) / resolution);
  return map.data().at(row * map.metadata().size_x() + column);
}

TEST(LocalCostmapServices, GetCostmapGivesNav2sNumbers) {
  const auto maps = costmaps(1, [](bw::Setup&) {});
  ASSERT_EQ(maps.size(), 1U);
  const auto& map = maps[0];
  EXPECT_EQ(map.header().frame_id(), "odom");
  EXPECT_NEAR(seconds_since_start(from_stamp(map.header().stamp())), 0.95, 0.06);  // the last sweep
  EXPECT_EQ(map.metadata().size_x(), 200U);
  EXPECT_EQ(map.data().size(), 40'000U);
  EXPECT_EQ(cost_at(map, {1.43, 0.0}), kLethalCost);
  EXPECT_EQ(cost_at(map, {1.18, 0.0}), kInscribedCost);  // 0.25 m before it: inscribed radius 0.3 m
  EXPECT_EQ(cost_at(map, {0.93, 0.0}), 138);             // trunc(252 exp(-3 * 0.2)), cell centres 0.5 m apart
  EXPECT_EQ(cost_at(map, {0.5, 0.0}), kFreeCost);
  EXPECT_EQ(cost_at(map, {2.5, 0.0}), kUnknownCost);
}

// A square of 2 m around the robot at (0.7, -0.4) holds the wall from y = -1.4 to 0.6 m.
TEST(LocalCostmapServices, ClearForgetsAroundExceptAndEverything) {
  std::vector<ClearCostmapAroundRobot::Response> around;
  std::vector<ClearCostmapExceptRegion::Response> except;
  std::vector<ClearEntireCostmap::Response> entirely;
  ClearCostmapAroundRobot::Request two_metres;
  two_metres.reset_distance(2.0F);
  ClearCostmapExceptRegion::Request three_metres;
  three_metres.reset_distance(3.0F);
  const auto maps = costmaps(4, [&](bw::Setup& setup) {
    call_at<ClearCostmapAroundRobot>(setup, "local_costmap/clear_around_local_costmap", {{1.4, two_metres}},
                                     around);
    call_at<ClearCostmapExceptRegion>(setup, "local_costmap/clear_except_local_costmap",
                                      {{1.6, three_metres}}, except);
    call_at<ClearEntireCostmap>(setup, "local_costmap/clear_entirely_local_costmap", {{1.8}}, entirely);
  });
  ASSERT_EQ(maps.size(), 4U);
  EXPECT_EQ(around.size() + except.size() + entirely.size(), 3U);
  const auto wall_at = [&](std::size_t map, double y) {
    return cost_at(maps[map], {1.43, y}) == kLethalCost;
  };
  for (const double y : {-2.2, -1.6, -1.2, 0.4, 0.8, 1.2}) EXPECT_TRUE(wall_at(0, y)) << y;
  for (const double y : {-2.2, -1.6, 0.8, 1.2}) EXPECT_TRUE(wall_at(1, y)) << y;
  for (const double y : {-1.2, 0.4}) EXPECT_FALSE(wall_at(1, y)) << y;
  for (const double y : {-1.6, 0.8}) EXPECT_TRUE(wall_at(2, y)) << y;  // within 1.5 m of -0.4
  for (const double y : {-2.2, 1.2}) EXPECT_FALSE(wall_at(2, y)) << y;
  for (const std::uint8_t cost : maps[3].data()) ASSERT_EQ(cost, kUnknownCost);
}

TEST(LocalCostmapServices, DistancesThatAreNoneClearNothing) {
  std::vector<ClearCostmapAroundRobot::Response> around;
  std::vector<ClearCostmapExceptRegion::Response> except;
  std::vector<TimedRequest<ClearCostmapAroundRobot>> arounds;
  std::vector<TimedRequest<ClearCostmapExceptRegion>> excepts;
  constexpr float kInf = std::numeric_limits<float>::infinity();
  for (const float distance : {-1.0F, kInf, -kInf, std::numeric_limits<float>::quiet_NaN()}) {
    arounds.push_back({1.4});
    arounds.back().request.reset_distance(distance);
    excepts.push_back({1.4});
    excepts.back().request.reset_distance(distance);
  }
  const auto maps = costmaps(2, [&](bw::Setup& setup) {
    call_at<ClearCostmapAroundRobot>(setup, "local_costmap/clear_around_local_costmap", arounds, around);
    call_at<ClearCostmapExceptRegion>(setup, "local_costmap/clear_except_local_costmap", excepts, except);
  });
  EXPECT_EQ(around.size(), 4U);
  EXPECT_EQ(except.size(), 4U);
  ASSERT_EQ(maps.size(), 2U);
  EXPECT_EQ(maps[1].data(), maps[0].data());
}

// As the costmap inside of Nav2's controller_server: in a namespace of its own, latched, and what nobody has
// seen costs nothing.
TEST(LocalCostmapServices, HasNav2sNamesInItsOwnNamespace) {
  nav_msgs::msg::OccupancyGrid shown;
  nav2_msgs::msg::Costmap raw;
  geometry_msgs::msg::PolygonStamped footprint;
  std::vector<GetCostmap::Response> responses;
  std::vector<ClearEntireCostmap::Response> cleared;
  run_with_script(
      "components: {local_costmap: {namespace: local_costmap, remap: {scan: /scan, tracks: /tracks, obstacles: /obstacles},"
      " parameters: {nav2_names: true, track_unknown_space: false, decay_time: 100.0}}}",
      2.0, [&](bw::Setup& setup) {
        setup.input<bandwagon_msgs::msg::Obstacles>("/obstacles", Qos::standard(),
                                                    [](const auto&, const Tick&) {});
        setup.input<nav_msgs::msg::OccupancyGrid>("/local_costmap/costmap", Qos::latched(),
                                                  [&](const auto& m, const Tick&) { shown = m; });
        setup.input<nav2_msgs::msg::Costmap>("/local_costmap/costmap_raw", Qos::latched(),
                                             [&](const auto& m, const Tick&) { raw = m; });
        setup.input<geometry_msgs::msg::PolygonStamped>("/local_costmap/published_footprint", Qos::standard(),
                                                        [&](const auto& m, const Tick&) { footprint = m; });
        setup.every(Duration::milliseconds(50), "robot",
                    [scan = setup.output<sensor_msgs::msg::LaserScan>("/scan", Qos::sensor()),
                     tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) {
                      tf2_msgs::msg::TFMessage message;
                      message.transforms().push_back(to_transform("odom", "base_link", tick.now, kX_OB));
                      tf.publish(message);
                      if (tick.sequence % 2 == 0 && seconds_since_start(tick.now) < 1.0)
                        scan.publish(sweep(tick.now));
                    });
        call_at<ClearEntireCostmap>(setup, "/local_costmap/clear_entirely_local_costmap", {{1.2}}, cleared);
        call_at<GetCostmap>(setup, "/local_costmap/get_costmap", {{1.1}, {1.3}}, responses);
      });
  ASSERT_EQ(raw.data().size(), 40'000U);
  EXPECT_EQ(raw.header().frame_id(), "odom");
  EXPECT_EQ(cost_at(raw, {1.43, 0.0}), kLethalCost);
  EXPECT_EQ(cost_at(raw, {2.5, 0.0}), kFreeCost) << "behind the wall, where nobody has looked";
  EXPECT_EQ(shown.data().size(), 40'000U);
  ASSERT_EQ(footprint.polygon().points().size(), 16U);
  for (const auto& corner : footprint.polygon().points()) {
    const Vector2 at(static_cast<double>(corner.x()), static_cast<double>(corner.y()));
    EXPECT_NEAR((at - kX_OB.position()).norm(), 0.3, 1e-5);
  }
  ASSERT_EQ(responses.size(), 2U);
  EXPECT_EQ(cost_at(responses[0].map(), {1.43, 0.0}), kLethalCost);
  EXPECT_EQ(cleared.size(), 1U);
  EXPECT_EQ(cost_at(responses[1].map(), {1.43, 0.0}), kFreeCost);
}

}  // namespace
}  // namespace bw
