// Nav2 without Nav2: its behaviour tree and its lifecycle manager, played by programs that share nothing with this project,
// drive our robot through the hallway full of people by our stand-ins for its servers; and the navigator that stands in for its
// bt_navigator drives by a controller and a planner that are not ours.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <gtest/gtest.h>

#include "tests/interop/nav2_tree/drive.hpp"
#include "tests/interop/nav2_tree/drive_figures.hpp"

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
  EXPECT_GT(figures.preemptions(), 5U * static_cast<unsigned>(drives())) << "a new path each second";
  EXPECT_EQ(figures.replaced_that_ended_otherwise(), 0) << "a goal that is replaced ends aborted";
}

}  // namespace
}  // namespace bw::test
