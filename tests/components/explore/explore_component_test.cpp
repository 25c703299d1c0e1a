// Exploring on its topics, in lock-step: a server of navigate_to_pose that does as it is told, and a room whose door is
// opened or closed on the map.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/string.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "tests/components/component_rig.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;
using ToPose = JazzyNav2::NavigateToPose;

// 6 by 3 m, closed but for its right side.
OccupancyGrid room(bool is_open) {
  OccupancyGrid grid;
  grid.resolution = 0.1;
  grid.width = 70;
  grid.height = 32;
  grid.cells.assign(70 * 32, OccupancyGrid::kUnknown);
  for (int row = 0; row < 32; ++row)
    for (int column = 0; column < 62; ++column) {
      const bool is_wall = row == 0 || row == 31 || column == 0 || (column == 61 && !is_open);
      grid.cells[grid.index(column, row)] = is_wall ? OccupancyGrid::kOccupied : OccupancyGrid::kFree;
    }
  return grid;
}

struct Exploring {
  std::vector<std::pair<double, bool>> maps{{0.5, true}};     ///< [s], is the door open
  std::vector<std::pair<double, bool>> resumes{{1.0, true}};  ///< [s], explore/resume
  /// What becomes of the goals, in their order; without more they are under way for good.
  std::vector<GoalStatus> ends;
  std::string text;  ///< of aborted ones

  std::vector<double> goals;  ///< x of each
  std::vector<double> cancelled_at;
  std::vector<std::string> status;
  std::size_t markers = 0;  ///< of the last message

  void go(double seconds) {
    using Handle = GoalHandle<ToPose>;
    run_with_script("ros_distro: jazzy\ncomponents: {explore: {}}", seconds, [&](Setup& setup) {
      // Goals under way, and when each may end.
      auto open = std::make_shared<std::vector<std::pair<double, Handle>>>();
      setup.action<ToPose>("navigate_to_pose",
                           {.on_goal =
                                [this, open](const Handle& handle, const Tick& tick) {
                                  goals.push_back(handle.goal().pose().pose().position().x());
                                  for (const auto& older : *open) older.second.abort({});
                                  open->clear();
                                  handle.execute();
                                  open->emplace_back(seconds_since_start(tick.now) + 1.5, handle);
                                },
                            .on_cancel =
                                [this, open](const Handle& handle, const Tick& tick) {
                                  cancelled_at.push_back(seconds_since_start(tick.now));
                                  handle.canceled({});
                                  std::erase_if(*open,
                                                [&](const auto& goal) { return goal.second == handle; });
                                },
                            .abandoned = [](const std::string&) { return ToPose::Result{}; }});
      setup.input<std_msgs::msg::String>("explore/status", Qos::latched(),
                                         [&](const auto& m, const Tick&) { status.push_back(m.data()); });
      setup.input<visualization_msgs::msg::MarkerArray>(
          "explore/frontiers", Qos::latched(),
          [&](const auto& m, const Tick&) { markers = m.markers().at(0).points().size(); });
      setup.every(Duration::milliseconds(100), "world",
                  [this, open, map = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched()),
                   pose = setup.output<nav_msgs::msg::Odometry>("odometry/filtered"),
                   resume = setup.output<std_msgs::msg::Bool>("explore/resume"), next_map = std::size_t{0},
                   next_resume = std::size_t{0}, ended = std::size_t{0}](const Tick& tick) mutable {
                    const double now = seconds_since_start(tick.now) + 1e-6;
                    nav_msgs::msg::Odometry odometry;
                    odometry.header(make_header("map", tick.now));
                    odometry.pose().pose(to_pose({1.0, 1.5, 0.0}));
                    pose.publish(odometry);
                    if (next_map < maps.size() && now >= maps[next_map].first)
                      map.publish(to_message(room(maps[next_map++].second), "map", tick.now));
                    if (next_resume < resumes.size() && now >= resumes[next_resume].first) {
                      std_msgs::msg::Bool message;
                      message.data(resumes[next_resume++].second);
                      resume.publish(message);
                    }
                    if (open->empty() || now < open->front().first || ended >= ends.size()) return;
                    const Handle handle = open->front().second;
                    open->erase(open->begin());
                    end(handle, ends[ended++]);
                  });
    });
  }

 private:
  void end(const GoalHandle<ToPose>& handle, GoalStatus status) const {
    ToPose::Result result;
    result.error_msg(text);
    if (status == GoalStatus::succeeded)
      handle.succeed(result);
    else
      handle.abort(result);
  }
};

// The door is at x = 6.15; the goal is as far from it as the robot is wide.
TEST(ExploreComponent, ExploresWhenItIsToldAndNotBefore) {
  Exploring run;
  run.resumes.clear();
  run.go(6.0);
  EXPECT_TRUE(run.goals.empty());
  EXPECT_THAT(run.status, ElementsAre("exploration_paused"));

  Exploring told;
  told.go(6.0);
  ASSERT_EQ(told.goals.size(), 1U);
  EXPECT_GT(told.goals[0], 5.4);
  EXPECT_LT(told.goals[0], 6.0);
  EXPECT_EQ(told.markers, 1U);
  EXPECT_THAT(told.status, ElementsAre("exploration_paused", "exploration_in_progress"));
}

// The map closes under way: back to where it began, and done.
TEST(ExploreComponent, AClosedMapIsComplete) {
  Exploring run;
  run.maps = {{0.5, true}, {2.5, false}};
  run.resumes = {{1.9, true}};
  run.ends = {GoalStatus::succeeded};
  run.go(10.0);
  ASSERT_EQ(run.goals.size(), 2U);
  EXPECT_NEAR(run.goals[1], 1.0, 1e-9);
  EXPECT_THAT(run.status, ElementsAre("exploration_paused", "exploration_in_progress", "returning_to_origin",
                                      "exploration_complete"));
}

TEST(ExploreComponent, PausedItCancelsItsGoal) {
  Exploring run;
  run.resumes = {{1.0, true}, {4.0, false}};
  run.go(6.0);
  EXPECT_EQ(run.goals.size(), 1U);
  ASSERT_EQ(run.cancelled_at.size(), 1U);
  EXPECT_NEAR(run.cancelled_at[0], 4.0, 0.21);
  EXPECT_EQ(run.status.back(), "exploration_paused");
}

// Twice not reached, then it returns: two goals to the door and one back.
TEST(ExploreComponent, AGoalThatFailsIsTriedOnceMore) {
  Exploring run;
  run.text = "no path";
  run.ends = {GoalStatus::aborted, GoalStatus::aborted, GoalStatus::succeeded};
  run.go(15.0);
  ASSERT_EQ(run.goals.size(), 3U);
  EXPECT_EQ(run.goals[0], run.goals[1]);
  EXPECT_NEAR(run.goals[2], 1.0, 1e-9);
  EXPECT_EQ(run.status.back(), "exploration_complete");
}

TEST(ExploreComponent, WhoeverSetsAnotherGoalHasTheRobot) {
  Exploring run;
  run.text = "preempted by goal 2";
  run.ends = {GoalStatus::aborted};
  run.go(10.0);
  EXPECT_EQ(run.goals.size(), 1U);
  EXPECT_EQ(run.status.back(), "exploration_paused");
}

}  // namespace
}  // namespace bw
