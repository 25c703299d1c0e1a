// `run --stay`: a graph that is there for goals, until somebody ends it.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

const std::string kGraph = std::string(BANDWAGON_SOURCE_DIR) + "/tests/interop/one_room.yaml";
std::string card_path() { return std::filesystem::temp_directory_path() / "stay.json"; }

std::vector<std::string> run(const std::vector<std::string>& options) {
  std::vector<std::string> command = {BANDWAGON_PROGRAM, "run", kGraph, "--json", card_path()};
  command.insert(command.end(), options.begin(), options.end());
  return command;
}

nlohmann::json card() { return nlohmann::json::parse(std::ifstream(card_path())); }

void send_goal(const std::string& x) {
  const Outcome sent = run_to_end({GOAL_ONCE, "jazzy", x, "1"}, std::chrono::seconds(30));
  EXPECT_EQ(sent.out, "sent " + x + "\n");
}

bool ends(const Process& graph, const std::string& goal) {
  return eventually([&] { return graph.err().find("goal " + goal + ": reached in") != std::string::npos; });
}

// Without a goal of its own it waits; after the first it waits again. 1 m to x = 2, 1 m to x = 3: one card of
// 2 m.
TEST(Stay, WaitsForGoalsUntilCtrlC) {
  Process graph(run({"--stay"}));
  send_goal("2");
  ASSERT_TRUE(ends(graph, "1")) << graph.err();
  send_goal("3");
  ASSERT_TRUE(ends(graph, "2")) << graph.err();
  EXPECT_TRUE(graph.running());
  // Who comes now, when nothing is said any more, hears how the last goal ended.
  const Outcome late =
      run_to_end({BANDWAGON_PROGRAM, "topic", "echo", "--once", "/navigation_status", "--for", "20"},
                 std::chrono::seconds(30));
  EXPECT_THAT(late.out, HasSubstr("goal_id: 2\nstatus: 4\nreason: reached\n"));
  graph.signal(SIGINT);
  EXPECT_EQ(graph.wait(std::chrono::seconds(20)), 0) << graph.err();
  EXPECT_THAT(graph.out(), HasSubstr("Last goal reached; the whole run since the first, "));
  EXPECT_EQ(card()["stayed"], true);
  EXPECT_EQ(card()["reached"], true);
  EXPECT_NEAR(card()["path_length_m"], 2.0, 0.5);  // both tolerances of 0.2 m, and a sample
}

// In virtual time: 1 m in about 4 s, and then it stands until the time is over.
TEST(Stay, GoesOnInLockStepUntilTheTimeIsOver) {
  const std::vector<std::string> options = {"--clock", "lockstep",
                                            "--for",   "12",
                                            "--set",   "navigator.goal.enabled=true",
                                            "--set",   "navigator.goal.x=2.0"};
  const Outcome left = run_to_end(run(options), std::chrono::seconds(60));
  EXPECT_EQ(left.status, 0) << left.err;
  EXPECT_THAT(left.out, HasSubstr("Goal reached in "));
  const double seconds = card()["time_to_goal_s"];
  EXPECT_LT(seconds, 8.0);

  std::vector<std::string> staying = options;
  staying.insert(staying.end(), {"--stay", "--pace", "0"});
  const Outcome stayed = run_to_end(run(staying), std::chrono::seconds(60));
  EXPECT_EQ(stayed.status, 0) << stayed.err;
  EXPECT_THAT(stayed.out, HasSubstr("Last goal reached; the whole run since the first, "));
  EXPECT_GT(card()["time_to_goal_s"], 10.0);  // of 12 s, less what passed before the goal was set
}

// A goal that cannot be reached is no failure of a graph that waits for others; without --stay it is.
TEST(Stay, EndsWellHoweverItsGoalsWent) {
  const std::vector<std::string> options = {"--clock", "lockstep",
                                            "--for",   "20",
                                            "--set",   "navigator.goal.enabled=true",
                                            "--set",   "navigator.goal.y=2.95"};
  EXPECT_EQ(run_to_end(run(options), std::chrono::seconds(60)).status, 1);
  std::vector<std::string> staying = options;
  staying.insert(staying.end(), {"--stay", "--pace", "0"});
  const Outcome stayed = run_to_end(run(staying), std::chrono::seconds(60));
  EXPECT_EQ(stayed.status, 0) << stayed.err;
  EXPECT_THAT(stayed.out, HasSubstr("Last goal not reached: "));
}

}  // namespace
}  // namespace bw::test
