// Nav2 without Nav2: its behaviour tree and its lifecycle manager, played by programs that share nothing with
// this project, drive our robot through the hallway full of people by our stand-ins for its servers; and the
// navigator that stands in for its bt_navigator drives by a controller and a planner that are not ours.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include <gtest/gtest.h>

#include "tests/interop/eventually.hpp"
#include "tests/interop/nav2_tree/drive.hpp"
#include "tests/interop/nav2_tree/drive_figures.hpp"
#include "tests/interop/nav2_tree/frames.hpp"
#include "tests/interop/plain/action_client.hpp"

namespace bw::test {
namespace {

const StandIns kServers = {.graphs = {"controller_server", "planner_server", "behavior_server"},
                           .nodes = {"controller_server", "planner_server", "behavior_server"}};
constexpr double kArrived = 0.35;  // [m] Nav2's xy_goal_tolerance, 0.25, and 0.1 for what localization errs

int drives() {
  const char* text = std::getenv("BANDWAGON_TREE_DRIVES");
  return text == nullptr ? 1 : std::atoi(text);
}

TEST(Nav2Tree, DrivesTheHallwayByOurServers) {
  DriveFigures figures;
  int good = 0;
  for (int seed = 1; seed <= drives(); ++seed) {
    const DriveReport report = drive_hallway(seed, kServers);
    ASSERT_TRUE(report.tree.is_object() && report.card.is_object()) << report.trouble;
    std::printf("%s\n", figures.add(seed, report).c_str());
    std::fflush(stdout);
    EXPECT_EQ(report.trouble, "");
    const bool is_good = report.tree["outcome"] == "succeeded" && report.left < kArrived &&
                         report.card["collisions_at_speed"] == 0;
    EXPECT_TRUE(is_good) << "seed " << seed << ": " << report.tree["troubles"].dump();
    good += is_good ? 1 : 0;
  }
  std::printf("%d of %d drives\n%s", good, drives(), figures.summary().c_str());
  EXPECT_LE(figures.added_dip(), 0.02) << "[m/s] on average, beyond what the planner does anyway";
  EXPECT_GT(figures.preemptions(), 5U * static_cast<unsigned>(drives())) << "a new path each second";
  EXPECT_EQ(figures.replaced_that_ended_otherwise(), 0) << "a goal that is replaced ends aborted";
}

int ended_well(const nlohmann::json& tree, const std::string& action) {
  constexpr int kSucceeded = 4;
  return static_cast<int>(std::ranges::count_if(
      tree["ends"], [&](const auto& end) { return end["action"] == action && end["status"] == kSucceeded; }));
}

// The map has a wall across the hallway that is not there, and nobody walks, who might stand behind a robot
// that backs up.
// Six recoveries in turn: clear, spin, wait, backup, clear, spin; the seven tries before and between them
// clear the global costmap once each. Clearing both counts twice: 2 * 2 + 4 + 7.
TEST(Nav2Tree, RecoversInTurnWhereNoWayLeads) {
  Body body(
      1, {"--set", "world.people.social.walkers=[]", "--set",
          "map_server.walls=[{x1: 0.0, y1: -3.0, x2: 20.0, y2: -3.0}, {x1: 0.0, y1: 3.0, x2: 20.0, y2: 3.0}, "
          "{x1: 10.0, y1: -3.6, x2: 10.0, y2: 3.6}]"});
  std::vector<std::unique_ptr<GraphRun>> runs = start(kServers);
  Player manager = manage(kServers.nodes);
  ASSERT_TRUE(manager.says("active")) << manager.process().out();
  const nlohmann::json tree = play_tree(19.0, 0.0);
  ASSERT_TRUE(tree.is_object());
  EXPECT_EQ(tree["outcome"], "failed");
  EXPECT_EQ(tree["compute_path_error_code"], 208);
  EXPECT_EQ(tree["recoveries"], 15) << tree["troubles"].dump();
  EXPECT_EQ(ended_well(tree, "spin"), 2);
  EXPECT_EQ(ended_well(tree, "wait"), 1);
  EXPECT_EQ(ended_well(tree, "backup"), 1);

  runs[1]->process().signal(SIGKILL);
  EXPECT_TRUE(manager.says("lost planner_server")) << manager.process().out();
  EXPECT_EQ(manager.process().wait(std::chrono::seconds(20)), 1) << "all have been taken down";
  runs.erase(runs.begin() + 1);
  for (const auto& run : runs) EXPECT_EQ(run->stop(), 0) << run->process().err();
  EXPECT_EQ(body.stop()["collisions_at_speed"], 0);
}

TEST(Nav2Tree, OurNavigatorDrivesByForeignServers) {
  const StandIns navigator{.graphs = {"bt_navigator"}, .nodes = {"bt_navigator"}};
  constexpr double kGoal = 4.0;  // [m] three ahead
  Body body(1, {"--set", "world.people.social.walkers=[]"});
  Player servers({NAV2_FOREIGN_SERVERS, "cmd_vel_nav"});
  const std::vector<std::unique_ptr<GraphRun>> runs = start(navigator);
  Player manager = manage(navigator.nodes);
  ASSERT_TRUE(manager.says("active")) << manager.process().out();

  plain::Node node("client");
  nav2::Frames frames(node);
  plain::ActionClient client(node, "/navigate_to_pose",
                             plain::action_type("nav2_msgs/action/NavigateToPose"));
  ASSERT_TRUE(eventually([&] {
    frames.poll();
    return frames.pose().has_value() && client.is_ready();
  }));
  plain::CdrOut goal;
  nav2::write(goal, nav2::PoseStamped{.header = {}, .pose = nav2::Pose::of(kGoal, 0.0, 0.0)});
  const plain::GoalId id = plain::goal_id(1);
  const auto accepted = client.send(id, goal.text("").bytes());
  ASSERT_TRUE(accepted && accepted->is_accepted);
  const std::int64_t asked = client.ask_result(id);
  std::optional<plain::Result> result;
  EXPECT_TRUE(eventually([&] {
    frames.poll();
    result = client.take_result(asked);
    return result.has_value();
  })) << runs[0]->process().err();
  ASSERT_TRUE(result.has_value());
  EXPECT_EQ(result->status, plain::GoalStatus::succeeded) << runs[0]->process().err();
  EXPECT_NEAR(frames.pose()->x, kGoal, kArrived);
  EXPECT_EQ(manager.stop(), 0) << manager.process().out();
  EXPECT_EQ(runs[0]->stop(), 0) << runs[0]->process().err();
  EXPECT_EQ(servers.stop(), 0);
  EXPECT_EQ(servers.process().out().find("ready\n0 plans"), std::string::npos) << "none was asked for";
}

}  // namespace
}  // namespace bw::test
