// Keep-out zones and the planner, in lock-step: plans, refusals and the global costmap.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/plan_result.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav2_msgs/msg/costmap.hpp>

#include "components/model/cell_cost.hpp"
#include "tests/components/global_planner/planner_rig.hpp"

namespace bw {
namespace {

using Answers = std::vector<bandwagon_msgs::msg::PlanResult>;
namespace codes = bandwagon_msgs::msg::PlanResult_Constants;
using testing::HasSubstr;

constexpr double kRadius = 0.3;  // of the rig's robot [m]

/// The zone from (2, 1.5) to (3, 6.1): cells of 0.2 m in a mask that is that zone alone, and reaches beyond
/// the map. The robot stands at (1, 3); the free way is along the lower wall.
OccupancyGrid zone_across() {
  OccupancyGrid mask{.resolution = 0.2, .origin = {2.0, 1.5}, .width = 5, .height = 23};
  mask.cells.assign(5 * 23, OccupancyGrid::kOccupied);
  return mask;
}

double distance_to_zone(const Vector2& p) {
  const Vector2 nearest(std::clamp(p.x(), 2.0, 3.0), std::clamp(p.y(), 1.5, 6.1));
  return (p - nearest).norm();
}

double closest(const nav_msgs::msg::Path& path) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& pose : path.poses())
    least = std::min(least, distance_to_zone({pose.pose().position().x(), pose.pose().position().y()}));
  return least;
}

struct Mask {
  double seconds = 0.0;  ///< when it is told; multiples of 0.1
  nav_msgs::msg::OccupancyGrid message;
};

nav_msgs::msg::OccupancyGrid told_in(const std::string& frame, const OccupancyGrid& mask = zone_across()) {
  return to_message(mask, frame, LockstepRunner::kStart);
}

struct Seen {
  Answers answers;
  std::vector<nav2_msgs::msg::Costmap> costmaps;
};

/// Asks for a plan to (x, 3) at 0.55 s, 1.55 s and so on.
Seen ask_for(const std::vector<double>& goals, const std::vector<Mask>& masks, Pose2 X_OB = {}) {
  Seen seen;
  PlannerWorld world{.X_OB = X_OB};
  world.seconds = 1.0 + static_cast<double>(goals.size());
  run_planner(world, [&](bw::Setup& setup) {
    setup.input<bandwagon_msgs::msg::PlanResult>(
        "plan_result", Qos::standard(), [&](const auto& m, const Tick&) { seen.answers.push_back(m); });
    setup.input<nav2_msgs::msg::Costmap>("global_costmap/costmap_raw", Qos::latched(),
                                         [&](const auto& m, const Tick&) { seen.costmaps.push_back(m); });
    setup.every(Duration::milliseconds(50), "asking",
                [masks, goals,
                 out = setup.output<nav_msgs::msg::OccupancyGrid>("keepout_filter_mask", Qos::latched()),
                 request = setup.output<bandwagon_msgs::msg::PlanRequest>("plan_request")](const Tick& tick) {
                  const double t = seconds_since_start(tick.now);
                  for (const Mask& mask : masks)
                    if (std::abs(t - mask.seconds) < 0.01) out.publish(mask.message);
                  for (std::size_t i = 0; i < goals.size(); ++i) {
                    if (std::abs(t - 0.55 - static_cast<double>(i)) > 0.01) continue;
                    bandwagon_msgs::msg::PlanRequest message;
                    message.id(i + 1);
                    message.goal().header(make_header("map", tick.now));
                    message.goal().pose(to_pose({goals[i], 3.0, 0.0}));
                    request.publish(message);
                  }
                });
  });
  EXPECT_EQ(seen.answers.size(), goals.size());
  return seen;
}

// Straight ahead, then round the zone, then straight again: it was taken away.
TEST(Keepout, ThePlanGoesRoundTheZoneAsLongAsItIsThere) {
  const OccupancyGrid nothing{.resolution = 0.05, .width = 1, .height = 1, .cells = {0}};
  const Seen seen = ask_for({4.0, 4.0, 4.0}, {{1.0, told_in("map")}, {2.0, told_in("map", nothing)}});
  for (const auto& answer : seen.answers) EXPECT_EQ(answer.status(), codes::SUCCEEDED) << answer.reason();
  EXPECT_EQ(closest(seen.answers[0].path()), 0.0);
  EXPECT_GE(closest(seen.answers[1].path()), kRadius - 2e-3);
  EXPECT_EQ(closest(seen.answers[2].path()), 0.0);

  // The global costmap with the map, with the zone, and without: at (2.55, 3.05) and (1.55, 3.05).
  ASSERT_EQ(seen.costmaps.size(), 3U);
  EXPECT_EQ(seen.costmaps[0].data()[3025], kFreeCost);
  EXPECT_EQ(seen.costmaps[1].data()[3025], kLethalCost);
  EXPECT_EQ(seen.costmaps[1].data()[3018], kInscribedCost);  // 0.15 m before it
  EXPECT_EQ(seen.costmaps[2].data(), seen.costmaps[0].data());
}

TEST(Keepout, AGoalWithinIsRefusedAsOneInAWall) {
  const Seen seen = ask_for({2.5, 5.05}, {{0.1, told_in("map")}});
  EXPECT_EQ(seen.answers[0].status(), codes::GOAL_BLOCKED);
  EXPECT_THAT(seen.answers[0].reason(), HasSubstr("(2.50, 3.00) lies in a keep-out zone"));
  EXPECT_EQ(seen.answers[0].error_code(), seen.answers[1].error_code());
  EXPECT_EQ(seen.answers[1].status(), codes::GOAL_BLOCKED);
  EXPECT_THAT(seen.answers[1].reason(), Not(HasSubstr("keep-out")));
}

// (2.5, 3) is 1.5 m to the right of odom's origin, which looks along y of the map.
TEST(Keepout, ARobotWithinStaysThere) {
  const Seen seen = ask_for({4.0}, {{0.1, told_in("map")}}, {0.0, -1.5, 0.0});
  EXPECT_EQ(seen.answers[0].status(), codes::START_BLOCKED);
  EXPECT_THAT(seen.answers[0].reason(), HasSubstr("(2.50, 3.00) lies in a keep-out zone"));
}

// In odom, which is turned by a right angle about (1, 3): x along y of the map, y against its x. The zone
// from (-1.5, -2) to (3.1, -1) there is the one above.
TEST(Keepout, AMaskMayBeInAnotherFrame) {
  OccupancyGrid mask{.resolution = 0.2, .origin = {-1.5, -2.0}, .width = 23, .height = 5};
  mask.cells.assign(5 * 23, OccupancyGrid::kOccupied);
  const Seen seen = ask_for({4.0, 2.5}, {{0.3, told_in("odom", mask)}});
  EXPECT_EQ(seen.answers[0].status(), codes::SUCCEEDED);
  EXPECT_GE(closest(seen.answers[0].path()), kRadius - 2e-3);
  EXPECT_EQ(seen.answers[1].status(), codes::GOAL_BLOCKED);
  // Where the zones are is not known: nothing is planned that might lead through them.
  const Seen unplaced = ask_for({4.0}, {{0.1, told_in("elsewhere")}});
  EXPECT_EQ(unplaced.answers[0].status(), codes::FAILED);
  EXPECT_THAT(unplaced.answers[0].reason(), HasSubstr("'elsewhere', which no transform joins to 'map'"));
}

TEST(Keepout, WhatIsNoMaskChangesNothing) {
  const std::vector<std::function<void(nav_msgs::msg::OccupancyGrid&)>> faults = {
      [](auto& m) { m.info().resolution(std::numeric_limits<float>::quiet_NaN()); },
      [](auto& m) { m.info().width(1000); },
      [](auto& m) { m.info().origin().position().x(std::numeric_limits<double>::infinity()); },
      [](auto& m) {
        m.info().origin(to_pose({2.0, 1.5, 0.5}));
      },
      [](auto& m) { m.data()[7] = 101; },
      [](auto& m) { m.header().frame_id(""); }};
  const OccupancyGrid nothing{.resolution = 0.2, .origin = {2.0, 1.5}, .width = 5, .height = 23};
  std::vector<Mask> masks = {{0.15, told_in("map")}};
  for (const auto& fault : faults) {
    OccupancyGrid free = nothing;
    free.cells.assign(5 * 23, OccupancyGrid::kFree);
    masks.push_back({masks.back().seconds + 0.05, told_in("map", free)});
    fault(masks.back().message);
  }
  const Seen seen = ask_for({4.0}, masks);
  EXPECT_GE(closest(seen.answers[0].path()), kRadius - 2e-3);
  EXPECT_EQ(seen.costmaps.size(), 2U);  // of the map, and of the one mask that is one
}

}  // namespace
}  // namespace bw
