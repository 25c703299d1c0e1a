// The planner's services in lock-step. Map: 10 x 6 m, cells of 0.1 m, a wall one cell thick at x = 5.0 to 5.1 m; the robot, of
// 0.3 m, stands at (1, 3). Odometry began elsewhere: odom is turned by a right angle.
#include <limits>
#include <numbers>

#include <bandwagon_msgs/msg/plan_request.hpp>
#include <bandwagon_msgs/msg/plan_result.hpp>
#include <bandwagon_msgs/msg/tracks.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav2_msgs/srv/get_costmap.hpp>
#include <nav2_msgs/srv/is_path_valid.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <tf2_msgs/msg/tf_message.hpp>

#include "components/messages/costmap.hpp"
#include "components/messages/grid.hpp"
#include "components/model/cell_cost.hpp"
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

const Pose2 kX_MO{1.0, 3.0, std::numbers::pi / 2.0};

OccupancyGrid floor_with_wall() {
  OccupancyGrid map{.resolution = 0.1, .width = 100, .height = 60};
  map.cells.assign(6000, OccupancyGrid::kFree);
  for (int row = 0; row < map.height; ++row) map.cells[map.index(50, row)] = OccupancyGrid::kOccupied;
  return map;
}

struct World {
  bool has_map = true;
  bool knows_its_place = true;
};

void run(const World& world, const std::function<void(Setup&)>& ask) {
  run_with_script("components: {global_planner: {}}", 3.0, [&](bw::Setup& setup) {
    setup.output<bandwagon_msgs::msg::PlanRequest>("plan_request");
    setup.every(Duration::milliseconds(100), "world",
                [world, map = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched()),
                 tf = setup.output<tf2_msgs::msg::TFMessage>("/tf", Qos::tf())](const Tick& tick) {
                  if (tick.sequence == 0 && world.has_map)
                    map.publish(to_message(floor_with_wall(), "map", tick.now));
                  if (!world.knows_its_place) return;
                  tf2_msgs::msg::TFMessage message;
                  message.transforms().push_back(to_transform("map", "odom", tick.now, kX_MO));
                  message.transforms().push_back(to_transform("odom", "base_link", tick.now, {}));
                  tf.publish(message);
                });
    ask(setup);
  });
}

IsPathValid::Request path_in(const std::string& frame, const std::vector<Pose2>& poses) {
  IsPathValid::Request request;
  request.path(to_path(frame, LockstepRunner::kStart, poses));
  return request;
}

std::vector<IsPathValid::Response> validity(const World& world,
                                            const std::vector<IsPathValid::Request>& paths) {
  std::vector<TimedRequest<IsPathValid>> requests;
  for (const auto& path : paths) requests.push_back({0.5, path});
  std::vector<IsPathValid::Response> responses;
  run(world, [&](bw::Setup& setup) { call_at<IsPathValid>(setup, "is_path_valid", requests, responses); });
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
  EXPECT_THAT(validity({.knows_its_place = false}, {path_in("map", {{5.05, 3.0, 0.0}, {2.0, 3.0, 0.0}})})[0]
                  .invalid_pose_indices(),
              ElementsAre(0));
}

// Numbers: path_check_test.cpp. There is nothing to clear, and whoever asks is answered.
TEST(PlannerServices, GlobalCostmapIsShownAndCleared) {
  std::vector<GetCostmap::Response> maps;
  std::vector<ClearEntireCostmap::Response> entirely;
  std::vector<ClearCostmapAroundRobot::Response> around;
  std::vector<ClearCostmapExceptRegion::Response> except;
  run({}, [&](bw::Setup& setup) {
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
  EXPECT_EQ(map.data()[3047], kInscribedCost);
  EXPECT_EQ(map.data()[3046], 217);
  EXPECT_EQ(map.data()[3020], kFreeCost);
  EXPECT_EQ(maps[1].map().data(), map.data());
}

}  // namespace
}  // namespace bw
