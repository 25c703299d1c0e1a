// `bandwagon launch`: a graph in several processes that are watched, end together, and are recorded by one more. The
// supervisor alone: tests/runtime/supervisor/.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <fstream>

#include <gmock/gmock.h>

#include "runtime/recording/bag/bag.hpp"
#include "tests/faults/outside_driver.hpp"
#include "tests/interop/launched.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

// /odom comes from the process world+base, /tracks from rest, /local_plan from planning.
TEST(Launch, RecordsWhatAllProcessesSay) {
  const Folder folder;
  launch(folder, {"--for", "7", "--record", folder / "drive.mcap", "--compression=none"});
  const auto recording = bag::open_bag(folder / "drive.mcap");
  for (const char* name : {"/odom", "/tracks", "/local_plan"}) {
    const auto topic = std::ranges::find(recording->topics(), name, &bag::BagTopic::name);
    ASSERT_NE(topic, recording->topics().end()) << name;
    EXPECT_GT(topic->message_count, 5U) << name;
  }
  const std::string manifest = text_of(folder / "logs" / "manifest.yaml");
  for (const char* process : {"world+base", "rest", "planning", "recorder"})
    EXPECT_THAT(manifest, HasSubstr(std::string(process) + ": exit status")) << process;
}

// The recorder ends at once, before the others know how to: they end all the same, and what there was is
// kept.
TEST(Launch, EndsAllWhenOneCannotBegin) {
  const Folder folder;
  std::ofstream(folder / "drive.mcap") << "of yesterday";
  const Outcome outcome = launch(folder, {"--for", "600", "--record", folder / "drive.mcap"});
  EXPECT_NE(outcome.status, -1) << "still ran after a minute";
  EXPECT_NE(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("drive.mcap"));
  EXPECT_EQ(text_of(folder / "drive.mcap"), "of yesterday");
}

// As the program takes them. The page is a process of its own: one that was asked for by --set=... was not
// started.
TEST(Launch, TakesItsOptionsWithAnEqualsSignToo) {
  const Folder folder;
  launch(folder, {"--for=3", "--set=viewer.enabled=true", "--set=viewer.port=0"});
  EXPECT_THAT(text_of(folder / "logs" / "manifest.yaml"), HasSubstr("viewer: exit status"));
  EXPECT_THAT(text_of(folder / "logs" / "viewer.out"), HasSubstr("?token="));
  for (const auto& log : std::filesystem::recursive_directory_iterator(folder / "logs"))
    EXPECT_EQ(log.status().permissions() & std::filesystem::perms(077), std::filesystem::perms::none) << log;
}

bool is_gone(pid_t id) {
  return eventually([id] { return kill(id, 0) != 0; });
}

TEST(Launch, AnswersRestartsAndStops) {
  Launched graph({"--stay", "--set=navigator.goal.enabled=false"});
  for (const char* name : {"rest", "planning"})
    ASSERT_TRUE(Launched::status_has(std::string(name) + " +up")) << graph.process().err();
  ASSERT_TRUE(Launched::status_has("world.base +up"));
  const pid_t planning = Launched::id("planning");
  const Outcome second = run_to_end(command(graph.folder, {"--stay"}), std::chrono::seconds(60));
  EXPECT_EQ(second.status, 2);
  EXPECT_THAT(second.err, HasSubstr("launched already, by process " + std::to_string(graph.process().id())));
  EXPECT_THAT(Launched::ask({"restart", "nothing"}), HasSubstr("no process \"nothing\""));
  Launched::ask({"restart", "planning"});
  EXPECT_TRUE(Launched::status_has("planning +up .*starts 2, up after .*nodes are up"));
  EXPECT_TRUE(is_gone(planning));
  kill(Launched::id("planning"), SIGKILL);
  EXPECT_TRUE(Launched::status_has("planning +up .*starts 3.*\n.*was killed by signal 9"));
  EXPECT_THAT(graph.process().err(),
              HasSubstr("started again; the process before it was killed by signal 9 (Killed)"));
  Launched::ask({"stop"});
  EXPECT_EQ(graph.process().wait(std::chrono::seconds(30)), 0) << graph.process().err();
  EXPECT_THAT(Launched::ask({"status"}), HasSubstr("nobody launches it"));
}

/// A drive of 6 m in the light hallway, in which the process `name` is killed on the way and the goal is reached without a
/// hand. Says how long what took; `stands`: until the next one is there.
void drive_and_kill(const std::string& name, bool stands, const std::string& expected) {
  using std::chrono::steady_clock;
  Spectator spectator;
  Launched graph({"--set=navigator.goal.x=7.0", "--for=120"});
  ASSERT_TRUE(spectator.sees([](const auto& sight) { return sight.x > 2.5 && sight.v > 0.4; }))
      << graph.process().err();
  kill(Launched::id(name), SIGKILL);
  const auto killed = steady_clock::now();
  const auto since = [killed] { return std::chrono::duration<double>(steady_clock::now() - killed).count(); };
  if (stands) {
    ASSERT_TRUE(spectator.sees([](const auto& sight) { return std::abs(sight.v) < 0.01; }));
    const double standing = since();
    ASSERT_TRUE(spectator.sees([](const auto& sight) { return sight.v > 0.1; })) << graph.process().err();
    std::printf("%s is killed: the robot stands after %.2f s and drives on after %.2f s\n", name.c_str(),
                standing, since());
  }
  EXPECT_EQ(graph.process().wait(std::chrono::seconds(90)), 0) << graph.process().err();
  EXPECT_THAT(graph.process().err(), HasSubstr(expected));
  EXPECT_NEAR(spectator.look()->x, 7.0, 0.35);  // the goal's tolerance, and the localization's error
  std::string log = text_of(graph.folder / "logs" / "launch.log");
  log.erase(0, log.find(name + " was killed"));
  std::printf("%s", log.c_str());
}

TEST(Launch, TheRobotStandsUntilAKilledPlannerIsBackAndReachesItsGoal) {
  drive_and_kill("planning", true, "planning was killed by signal 9 (Killed); it is started again");
}

// With the process go the pose and the goal; the next one finds both. The planner stops when what it plans by is old.
TEST(Launch, AKilledLocalizationAndNavigatorGoOnWhereTheyWere) {
  drive_and_kill("rest", false,
                 "the goal of the process before this one, (7.00, 0.00, 0.00), is taken up again");
}

// The kernel tells each child: it brings what it moves to rest, and ends.
TEST(Launch, ItsProcessesEndWhenItIsKilled) {
  Launched graph({"--stay"});
  std::vector<pid_t> ids;
  for (const char* name : {"world.base", "rest", "planning"}) {
    ASSERT_TRUE(Launched::status_has(std::string(name) + " +up")) << graph.process().err();
    ids.push_back(Launched::id(name));
  }
  graph.process().signal(SIGKILL);
  for (const pid_t id : ids) EXPECT_TRUE(is_gone(id)) << id;
  EXPECT_THAT(text_of(graph.folder / "logs" / "launch.log"), HasSubstr("is up after"));
}

// systemd-analyze reads them as systemd would.
TEST(Launch, WritesUnitsThatSystemdTakes) {
  const Folder folder;
  const Outcome outcome =
      launch(folder, {"--systemd", folder / "units", "--stay", "--page", "--set=robot.name=R 2 $5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(folder / "logs"));
  const std::string unit = text_of(folder / "units" / "bandwagon-hallway-world_base.service");
  for (const char* line :
       {"Type=notify\n", "WatchdogSec=900ms\n", "Restart=on-failure\n", "StartLimitBurst=6\n",
        "\"--only=world+base\"", "\"--stay\" \"--page\"", "\"--set=robot.name=R 2 $$5\"",
        "ProtectSystem=strict\n", "PartOf=bandwagon-hallway.target\n"})
    EXPECT_THAT(unit, HasSubstr(line));
  EXPECT_THAT(unit, testing::Not(HasSubstr("MemoryMax")));
  EXPECT_THAT(text_of(folder / "units" / "bandwagon-hallway-planning.service"),
              HasSubstr("MemoryMax=1500000000\nMemorySwapMax=0\nOOMPolicy=kill\n"));
  EXPECT_THAT(text_of(folder / "units" / "bandwagon-hallway.target"),
              HasSubstr("Wants=bandwagon-hallway-viewer.service\n"));
  const char* analyze = "/usr/bin/systemd-analyze";
  if (!std::filesystem::exists(analyze))
    GTEST_SKIP() << "no systemd-analyze: that systemd takes them is not tried";
  std::vector<std::string> verify = {analyze, "verify", "--man=no", "--recursive-errors=no"};
  for (const auto& file : std::filesystem::directory_iterator(folder / "units"))
    verify.push_back(file.path());
  const Outcome verdict = run_to_end(verify, std::chrono::seconds(60),
                                     {{"SYSTEMD_UNIT_PATH", (folder / "units").string() + ":"}});
  EXPECT_EQ(verdict.status, 0) << verdict.err;
  EXPECT_THAT(verdict.err, testing::Not(HasSubstr("bandwagon-hallway"))) << "systemd warns";
}

TEST(Launch, RefusesAPageOfOneProcessAlone) {
  const Folder folder;
  const Outcome outcome = launch(folder, {"--html", folder / "drive.html"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--record FILE"));
  EXPECT_FALSE(std::filesystem::exists(folder / "logs"));
}

}  // namespace
}  // namespace bw::test
