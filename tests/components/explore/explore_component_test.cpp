// The component on its topics in lock-step: a room with two doors, a robot that stands still, and a script in place of
// navigator and map. Numbers of the doors: frontier_search_test.cpp. The robot is a disc of 0.2 m, and stands at
// (1.05, 1.45); the right door's goal is (3.75, 1.45), the left one's (0.25, 1.45), which is nearer.
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <bandwagon_msgs/msg/base_state.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map_msgs/msg/occupancy_grid_update.hpp>
#include <nav2_msgs/action/navigate_to_pose.hpp>
#include <nav_msgs/msg/occupancy_grid.hpp>
#include <nav_msgs/msg/odometry.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/string.hpp>
#include <visualization_msgs/msg/marker_array.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/grid.hpp"
#include "components/messages/nav2_results.hpp"
#include "tests/components/explore/explore_maps.hpp"
#include "tests/components/sent_goals.hpp"

namespace bw {
namespace {

using explore::test::closed_room;
using explore::test::fill;
using explore::test::room_with_door;
using nav2_msgs::action::NavigateToPose;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

constexpr Pose2 kStand{1.05, 1.45, 0.0};

OccupancyGrid room_with_two_doors() {
  OccupancyGrid map = room_with_door(10, 20);
  fill(map, -1, 10, 0, 20, OccupancyGrid::kFree);
  return map;
}

/// What others do, and what the component does.
struct Play {
  struct Sent {
    GoalHandle<NavigateToPose> handle;
    double x = 0.0;
    double at = 0.0;  ///< [s]
    bool canceled = false;
  };

  std::vector<std::pair<double, std::function<void(Play&)>>> acts;
  double seconds = 12.0;
  bool has_pose = true;

  std::vector<Sent> goals;
  std::vector<std::string> statuses;
  std::vector<visualization_msgs::msg::MarkerArray> markers;
  Output<nav_msgs::msg::OccupancyGrid> map;
  Output<map_msgs::msg::OccupancyGridUpdate> updates;
  Output<std_msgs::msg::Bool> resume;
  Time now;

  void tell_map(const OccupancyGrid& grid) { map.publish(to_message(grid, "map", now)); }
  void tell(bool go) {
    std_msgs::msg::Bool message;
    message.data(go);
    resume.publish(message);
  }
  void abort(const std::string& why) {
    NavigateToPose::Result result;
    set_error(result, 106, why);
    goals.back().handle.abort(result);
  }
  void succeed() { goals.back().handle.succeed({}); }
  std::vector<double> xs() const {
    std::vector<double> xs;
    for (const Sent& goal : goals) xs.push_back(std::round(100.0 * goal.x) / 100.0);
    return xs;
  }
};

void run(Play& play) {
  run_with_script(
      "robot: {radius: 0.2}\ncomponents: {explore: {inputs: {}}}", play.seconds, [&](Setup& setup) {
        play.map = setup.output<nav_msgs::msg::OccupancyGrid>("map", Qos::latched());
        play.updates = setup.output<map_msgs::msg::OccupancyGridUpdate>("map_updates");
        play.resume = setup.output<std_msgs::msg::Bool>("explore/resume");
        setup.input<std_msgs::msg::String>(
            "explore/status", Qos::latched(),
            [&](const auto& message, const Tick&) { play.statuses.push_back(message.data()); });
        setup.input<visualization_msgs::msg::MarkerArray>(
            "explore/frontiers", Qos::latched(),
            [&](const auto& message, const Tick&) { play.markers.push_back(message); });
        setup.action<NavigateToPose>(
            "navigate_to_pose", {.on_goal =
                                     [&](const GoalHandle<NavigateToPose>& goal, const Tick& tick) {
                                       goal.execute();
                                       play.goals.push_back({goal, goal.goal().pose().pose().position().x(),
                                                             seconds_since_start(tick.now)});
                                     },
                                 .on_cancel =
                                     [&](const GoalHandle<NavigateToPose>& goal, const Tick&) {
                                       for (Play::Sent& sent : play.goals)
                                         if (sent.handle == goal) sent.canceled = true;
                                       goal.canceled({});
                                     },
                                 .abandoned = [](const std::string&) { return NavigateToPose::Result(); }});
        setup.every(
            Duration::milliseconds(100), "odometry",
            [&, odometry = setup.output<nav_msgs::msg::Odometry>("odometry/filtered")](const Tick& tick) {
              play.now = tick.now;
              if (!play.has_pose) return;
              nav_msgs::msg::Odometry message;
              message.header(make_header("map", tick.now));
              message.child_frame_id("base_link");
              message.pose().pose(to_pose(kStand));
              odometry.publish(message);
            });
        std::vector<std::pair<double, std::function<void()>>> acts;
        for (auto& [at, act] : play.acts) acts.emplace_back(at, [&play, act = act] { act(play); });
        at_times(setup, std::move(acts));
      });
}

const auto kGo = [](Play& play) { play.tell(true); };
const auto kStop = [](Play& play) { play.tell(false); };
const auto kTwoDoors = [](Play& play) { play.tell_map(room_with_two_doors()); };
const auto kRightDoor = [](Play& play) { play.tell_map(room_with_door(10, 20)); };
const auto kClosed = [](Play& play) { play.tell_map(closed_room()); };

TEST(ExploreComponent, StartsPausedAndSendsTheNearerDoor) {
  Play play{.acts = {{0.5, kTwoDoors}, {3.55, kGo}}, .seconds = 6.0};
  run(play);
  EXPECT_THAT(play.xs(), ElementsAre(0.25));
  EXPECT_GT(play.goals.at(0).at, 3.5);
  EXPECT_LT(play.goals.at(0).at, 4.6);  // it looks once a second
  ASSERT_THAT(play.statuses, SizeIs(2));
  EXPECT_THAT(play.statuses[0], StartsWith("exploration_paused"));
  EXPECT_THAT(play.statuses[1], StartsWith("exploration_in_progress"));
  ASSERT_FALSE(play.markers.empty());
  EXPECT_THAT(play.markers.back().markers().at(0).points(), SizeIs(2));
}

TEST(ExploreComponent, AVanishedFrontierGivesWayToTheNextAndThenItReturns) {
  // The map closes at 7.5 s, and after looks at 8, 9 and 10 s nothing is left.
  Play play{.acts = {{0.5, kTwoDoors},
                     {1.5, kGo},
                     {4.5, kRightDoor},
                     {7.5, kClosed},
                     {11.5, [](Play& p) { p.succeed(); }}},
            .seconds = 13.0};
  run(play);
  ASSERT_THAT(play.xs(), ElementsAre(0.25, 3.75, 1.05));
  EXPECT_NEAR(play.goals[2].at, 10.0, 0.1);
  ASSERT_FALSE(play.statuses.empty());
  EXPECT_EQ(play.statuses.back(), "exploration_complete: 3 goals, 0 not reached");
  EXPECT_FALSE(play.goals[0].canceled);  // the newer goal takes its place
}

TEST(ExploreComponent, AFailureComesOntoTheBlacklistAndHasASecondChance) {
  const auto fail = [](Play& p) { p.abort("no way"); };
  Play play{.acts = {{0.5, kTwoDoors},
                     {1.5, kGo},
                     {3.5, fail},
                     {5.5, fail},
                     {7.5, fail},
                     {9.5, fail},
                     {13.5, [](Play& p) { p.succeed(); }}},
            .seconds = 15.0};
  run(play);
  // Both fail, both are tried again, and then it gives up.
  EXPECT_THAT(play.xs(), ElementsAre(0.25, 3.75, 0.25, 3.75, 1.05));
  EXPECT_EQ(
      play.statuses.back(),
      "exploration_complete: 5 goals, 4 not reached; left: (-0.0, 1.5) not reached: no way; (4.1, 1.5) not "
      "reached: no way");
}

TEST(ExploreComponent, PausingCancelsTheGoalAndResumingSendsItAgain) {
  Play play{.acts = {{0.5, kTwoDoors}, {1.5, kGo}, {4.5, kStop}, {8.5, kGo}}};
  run(play);
  ASSERT_THAT(play.xs(), ElementsAre(0.25, 0.25));
  EXPECT_TRUE(play.goals[0].canceled);
  EXPECT_GT(play.goals[1].at, 8.5);
  EXPECT_THAT(play.statuses.at(2), StartsWith("exploration_paused"));
}

TEST(ExploreComponent, WhoeverTakesTheRobotOverKeepsIt) {
  Play play{.acts = {{0.5, kTwoDoors}, {1.5, kGo}, {4.5, [](Play& p) { p.abort("preempted by goal 7"); }}}};
  run(play);
  EXPECT_THAT(play.xs(), ElementsAre(0.25));
  EXPECT_THAT(play.statuses.back(), StartsWith("exploration_paused"));
}

TEST(ExploreComponent, WithoutAPoseNoFrontierIsBlamed) {
  Play play{.acts = {{0.5, kRightDoor},
                     {1.5, kGo},
                     {3.5, [](Play& p) { p.has_pose = false; }},
                     {6.5, [](Play& p) { p.abort("no pose"); }},
                     {8.5, [](Play& p) { p.has_pose = true; }}}};
  run(play);
  ASSERT_THAT(play.xs(), ElementsAre(3.75, 3.75));
  EXPECT_GT(play.goals[1].at, 8.5);
  EXPECT_THAT(play.statuses, Contains(HasSubstr("waits: odometry/filtered does not say where the robot is")));
  EXPECT_EQ(play.statuses.back(), "exploration_in_progress: 2 goals, 0 not reached");
}

TEST(ExploreComponent, SaysNothingIsKnownOfWhereItIs) {
  Play play{.acts = {{0.5, kRightDoor}, {1.5, kGo}}, .seconds = 4.0, .has_pose = false};
  run(play);
  EXPECT_THAT(play.goals, IsEmpty());
  EXPECT_EQ(
      play.statuses.back(),
      "exploration_paused: 0 goals, 0 not reached; waits: odometry/filtered does not say where the robot is");
}

TEST(ExploreComponent, FollowsUpdatesOfTheMap) {
  Play play{.acts = {{0.5, kTwoDoors}, {1.5, kGo}}, .seconds = 6.0};
  // The left door, one column of ten cells from (-0.1, 1.0) on, turns out to be a wall.
  play.acts.emplace_back(3.5, [](Play& p) {
    map_msgs::msg::OccupancyGridUpdate update;
    update.header(make_header("map", p.now));
    update.x(9);
    update.y(20);
    update.width(1);
    update.height(10);
    update.data().assign(10, OccupancyGrid::kOccupied);
    p.updates.publish(update);
  });
  run(play);
  EXPECT_THAT(play.xs(), ElementsAre(0.25, 3.75));
}

}  // namespace
}  // namespace bw
