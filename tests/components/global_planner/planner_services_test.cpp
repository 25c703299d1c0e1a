// The planner's services in lock-step.
#include <limits>

#include <geometry_msgs/msg/polygon_stamped.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <lyrical/nav2_msgs/srv/clear_entire_costmap.hpp>
#include <nav2_msgs/srv/clear_costmap_around_robot.hpp>
#include <nav2_msgs/srv/clear_costmap_except_region.hpp>
#include <nav2_msgs/srv/clear_entire_costmap.hpp>
#include <nav2_msgs/srv/get_costmap.hpp>
#include <nav2_msgs/srv/is_path_valid.hpp>

#include "components/messages/costmap.hpp"
#include "components/model/cell_cost.hpp"
#include "tests/components/global_planner/planner_rig.hpp"
#include "tests/components/service_calls.hpp"

namespace bw {
namespace {

using nav2_msgs::srv::ClearCostmapAroundRobot;
using nav2_msgs::srv::ClearCostmapExceptRegion;
using nav2_msgs::srv::ClearEntireCostmap;
using nav2_msgs::srv::GetCostmap;
using nav2_msgs::srv::IsPathValid;
using testing::ElementsAre;
using testing::IsEmpty;

IsPathValid::Request path_in(const std::string& frame, const std::vector<Pose2>& poses) {
  IsPathValid::Request request;
  request.path(to_path(frame, LockstepRunner::kStart, poses));
  return request;
}

std::vector<IsPathValid::Response> validity(const PlannerWorld& world,
                                            const std::vector<IsPathValid::Request>& paths) {
  std::vector<TimedRequest<IsPathValid>> requests;
  for (const auto& path : paths) requests.push_back({0.5, path});
  std::vector<IsPathValid::Response> responses;
  run_planner(world,
              [&](bw::Setup& setup) { call_at<IsPathValid>(setup, "is_path_valid", requests, responses); });
  EXPECT_EQ(responses.size(), paths.size());
  return responses;
}

TEST(PlannerServices, IsPathValidLooksAhead) {
  const auto answers =
      validity({}, {path_in("map", {{1.0, 3.0, 0.0}, {2.0, 3.0, 0.0}, {4.0, 3.0, 0.0}}),
                    path_in("map", {{5.05, 3.0, 0.0}, {2.0, 3.0, 0.0}}),
                    path_in("map", {{2.0, 3.0, 0.0}, {5.05, 3.0, 0.0}, {9.0, 3.0, 0.0}, {11.0, 3.0, 0.0}}),
                    // 0.5 m to the right of the robot's start is 0.5 m along x of the map.
                    path_in("odom", {{0.0, -0.5, 0.0}, {0.0, -4.05, 0.0}, {0.0, -6.0, 0.0}})});
  ASSERT_EQ(answers.size(), 4U);
  EXPECT_TRUE(answers[0].is_valid());
  EXPECT_THAT(answers[0].invalid_pose_indices(), IsEmpty());
  EXPECT_TRUE(answers[1].is_valid());  // in the wall, and behind the robot
  EXPECT_FALSE(answers[2].is_valid());
  EXPECT_THAT(answers[2].invalid_pose_indices(), ElementsAre(1, 3));
  EXPECT_FALSE(answers[3].is_valid());
  EXPECT_THAT(answers[3].invalid_pose_indices(), ElementsAre(1));
}

TEST(PlannerServices, IsPathValidRefusesWhatIsNoPath) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Pose2> long_path(100'000, Pose2{2.0, 3.0, 0.0});
  long_path.back().x = 5.05;
  const auto answers =
      validity({}, {path_in("map", {}), path_in("elsewhere", {{2.0, 3.0, 0.0}}),
                    path_in("map", {{kNan, 3.0, 0.0}, {2.0, 3.0, 0.0}}), path_in("map", long_path)});
  ASSERT_EQ(answers.size(), 4U);
  for (const auto& answer : answers) EXPECT_EQ(answer.is_valid(), &answer == &answers[2]);
  EXPECT_THAT(answers[0].invalid_pose_indices(), IsEmpty());
  EXPECT_THAT(answers[1].invalid_pose_indices(), IsEmpty());
  EXPECT_THAT(answers[3].invalid_pose_indices(), ElementsAre(99'999));
  EXPECT_FALSE(validity({.has_map = false}, {path_in("map", {{2.0, 3.0, 0.0}})})[0].is_valid());
  // Not knowing where the robot is, it looks at all of the path.
  EXPECT_THAT(validity({.knows_its_pose = false}, {path_in("map", {{5.05, 3.0, 0.0}, {2.0, 3.0, 0.0}})})[0]
                  .invalid_pose_indices(),
              ElementsAre(0));
}

// Numbers: path_check_test.cpp. There is nothing to clear, and whoever asks is answered.
TEST(PlannerServices, GlobalCostmapIsShownAndCleared) {
  std::vector<GetCostmap::Response> maps;
  std::vector<ClearEntireCostmap::Response> entirely;
  std::vector<ClearCostmapAroundRobot::Response> around;
  std::vector<ClearCostmapExceptRegion::Response> except;
  run_planner({}, [&](bw::Setup& setup) {
    call_at<GetCostmap>(setup, "global_costmap/get_costmap", {{0.5}, {1.5}}, maps);
    call_at<ClearEntireCostmap>(setup, "global_costmap/clear_entirely_global_costmap", {{1.0}}, entirely);
    call_at<ClearCostmapAroundRobot>(setup, "global_costmap/clear_around_global_costmap", {{1.0}}, around);
    call_at<ClearCostmapExceptRegion>(setup, "global_costmap/clear_except_global_costmap", {{1.0}}, except);
  });
  EXPECT_EQ(entirely.size() + around.size() + except.size(), 3U);
  ASSERT_EQ(maps.size(), 2U);
  const auto& map = maps[0].map();
  EXPECT_EQ(map.header().frame_id(), "map");
  EXPECT_EQ(map.metadata().size_x(), 100U);
  EXPECT_EQ(map.metadata().size_y(), 60U);
  ASSERT_EQ(map.data().size(), 6000U);
  EXPECT_EQ(map.data()[3050], kLethalCost);
  EXPECT_EQ(map.data()[3048], kInscribedCost);
  EXPECT_EQ(map.data()[3047], 252);  // its far edge is as far from the wall as the robot's radius
  EXPECT_EQ(map.data()[3046], 217);
  EXPECT_EQ(map.data()[3020], kFreeCost);
  EXPECT_EQ(maps[1].map().data(), map.data());
}

TEST(PlannerServices, InLyricalWhoClearsIsToldThatItIsDone) {
  using Clear = lyrical::nav2_msgs::srv::ClearEntireCostmap;
  std::vector<Clear::Response> entirely;
  run_planner({.distro = "lyrical"}, [&](bw::Setup& setup) {
    call_at<Clear>(setup, "global_costmap/clear_entirely_global_costmap", {{1.0}}, entirely);
  });
  ASSERT_EQ(entirely.size(), 1U);
  EXPECT_TRUE(entirely[0].success());
}

// Nav2's table: 254 is shown as 100, 253 as 99, 252 as 98, 0 as 0. The footprint is a 16-gon of 0.3 m around
// the robot, once a second.
TEST(GlobalCostmap, IsPublishedAsNav2Does) {
  std::vector<nav_msgs::msg::OccupancyGrid> grids;
  std::vector<nav2_msgs::msg::Costmap> raw;
  std::vector<geometry_msgs::msg::PolygonStamped> footprints;
  run_planner({}, [&](bw::Setup& setup) {
    setup.input<nav_msgs::msg::OccupancyGrid>("global_costmap/costmap", Qos::latched(),
                                              [&](const auto& m, const Tick&) { grids.push_back(m); });
    setup.input<nav2_msgs::msg::Costmap>("global_costmap/costmap_raw", Qos::latched(),
                                         [&](const auto& m, const Tick&) { raw.push_back(m); });
    setup.input<geometry_msgs::msg::PolygonStamped>(
        "global_costmap/published_footprint", Qos::standard(),
        [&](const auto& m, const Tick&) { footprints.push_back(m); });
  });
  ASSERT_EQ(grids.size(), 1U);
  ASSERT_EQ(raw.size(), 1U);
  EXPECT_EQ(grids[0].header().frame_id(), "map");
  EXPECT_EQ(raw[0].data()[3050], kLethalCost);
  EXPECT_EQ(grids[0].data()[3050], 100);
  EXPECT_EQ(grids[0].data()[3048], 99);
  EXPECT_EQ(grids[0].data()[3047], 98);
  EXPECT_EQ(grids[0].data()[3020], 0);
  ASSERT_EQ(footprints.size(), 3U);
  EXPECT_EQ(footprints[0].header().frame_id(), "map");
  ASSERT_EQ(footprints[0].polygon().points().size(), 16U);
  // Ahead of a robot that faces along y of the map.
  EXPECT_NEAR(footprints[0].polygon().points()[0].x(), 1.0, 1e-6);
  EXPECT_NEAR(footprints[0].polygon().points()[0].y(), 3.3, 1e-6);
}

}  // namespace
}  // namespace bw
