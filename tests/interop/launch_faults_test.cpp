// `bandwagon launch` when its processes fail: the base killed, faults by the graph, a machine that is busy.
#include <chrono>
#include <cmath>
#include <csignal>
#include <fstream>
#include <memory>

#include <gmock/gmock.h>

#include "tests/faults/outside_driver.hpp"
#include "tests/interop/launched.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

// Whose process it was that drove waits for a release when it is started again: the robot stands whatever the goal is, and one
// release later goes on. The world is a process of its own: it is not killed.
TEST(LaunchFaults, AKilledBaseComesBackLatchedAndGoesOnAfterOneRelease) {
  Spectator spectator;
  Launched graph({"--set=world.process=world", "--set=navigator.goal.x=7.0", "--for=120"});
  ASSERT_TRUE(spectator.sees([](const auto& sight) { return sight.x > 2.0 && sight.v > 0.4; }))
      << graph.process().err();
  kill(Launched::id("world.base"), SIGKILL);
  ASSERT_TRUE(Launched::status_has("world.base +up .*starts 2")) << graph.process().err();
  ASSERT_TRUE(spectator.sees_it_stand());
  EXPECT_LT(spectator.moves_within(2.0), 0.02);
  EXPECT_TRUE(eventually([] {
    const Outcome call =
        run_to_end({BANDWAGON_PROGRAM, "service", "call", "/release_stop"}, std::chrono::seconds(20));
    return call.status == 0 && call.out.find("success: true") != std::string::npos;
  }));
  EXPECT_TRUE(spectator.sees([](const auto& sight) { return sight.v > 0.1; })) << graph.process().err();
  EXPECT_EQ(graph.process().wait(std::chrono::seconds(90)), 0) << graph.process().err();
  EXPECT_NEAR(spectator.look()->x, 7.0, 0.35);
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// launch.log of a robot that stands, in which `faults` go wrong: until `text` is in it `times`, or for as long as `options` say.
std::string log_with_faults(const std::string& faults, const std::vector<std::string>& options,
                            const std::string& text = "", int times = 0) {
  const Folder settings;
  std::ofstream(settings / "faults.yaml") << faults;
  std::vector<std::string> words = {"--stay", "--set=navigator.goal.enabled=false",
                                    "--set=faults=" + (settings / "faults.yaml").string()};
  words.insert(words.end(), options.begin(), options.end());
  Launched graph(words);
  const auto log = [&] { return text_of(graph.folder / "logs" / "launch.log"); };
  if (times > 0) {
    EXPECT_TRUE(eventually([&] { return count(log(), text) >= times; })) << log();
    Launched::ask({"stop"});
  }
  graph.process().wait(std::chrono::seconds(60));
  return log();
}

// Time of the run is that of the launch: the next process of that name is not killed again.
TEST(LaunchFaults, AFaultOfTheGraphKillsAProcessOnce) {
  const std::string log =
      log_with_faults("f: {kind: process_killed, of: local_planner, from: 6s}\n", {"--for=12"});
  EXPECT_THAT(log, HasSubstr("planning was killed by signal 9 (Killed)"));
  EXPECT_EQ(count(log, "; it is started again"), 1) << log;
  EXPECT_EQ(count(log, "planning is up after"), 2) << log;
}

TEST(LaunchFaults, ALaneThatSpinsIsNamedAndItsProcessStartedAgain) {
  const std::string log = log_with_faults("f: {kind: process_spins, of: local_planner, from: 6s}\n", {},
                                          "planning is up after", 2);
  EXPECT_THAT(log, HasSubstr("planning is killed: "));
  EXPECT_THAT(log, HasSubstr("lane local"));
  EXPECT_EQ(count(log, "planning is up after"), 2) << log;
}

// It takes no more than the graph allows: not the machine's memory, and nobody else notices.
TEST(LaunchFaults, AProcessThatLeaksEndsAtItsLimitAlone) {
  const std::string log = log_with_faults(
      "f: {kind: process_leaks, of: local_planner, from: 6s, for: 5s, parameters: {rate: 2000, most: 2000}}\n",
      {}, "planning is up after", 2);
  EXPECT_EQ(count(log, "; it is started again"), 1) << log;
  EXPECT_THAT(log, HasSubstr("bad_alloc"));
  EXPECT_EQ(count(log, "planning is up after"), 2) << log;
  EXPECT_EQ(count(log, "rest is up after"), 1) << log;
}

// Four that take all the time they get: nobody is ended as if he hung.
TEST(LaunchFaults, NobodyIsKilledBecauseTheMachineIsBusy) {
  std::vector<std::unique_ptr<Process>> spinners;
  for (int i = 0; i < 4; ++i)
    spinners.push_back(
        std::make_unique<Process>(std::vector<std::string>{"/bin/sh", "-c", "while :; do :; done"}));
  const std::string log = log_with_faults("{}\n", {"--for=12"});
  EXPECT_EQ(count(log, " is up after"), 3) << log;
  EXPECT_EQ(count(log, " is killed: "), 0) << log;
  EXPECT_EQ(count(log, "; it is started again"), 0) << log;
}

}  // namespace
}  // namespace bw::test
