// launch_scripts/split.sh: a graph in several processes that end together, recorded by one more.
#include <algorithm>
#include <csignal>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "runtime/recording/bag/bag.hpp"
#include "tests/folder.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;

Outcome split(const Folder& folder, const std::vector<std::string>& options) {
  const std::string root = BANDWAGON_SOURCE_DIR;
  std::vector<std::string> command = {root + "/launch_scripts/split.sh", root + "/config/graphs/hallway.yaml",
                                      "--set", "world.people.social.walkers=[]"};
  command.insert(command.end(), options.begin(), options.end());
  return run_to_end(command, std::chrono::seconds(60),
                    {{"BANDWAGON_PROGRAM", BANDWAGON_PROGRAM}, {"BANDWAGON_LOG_DIR", folder / "logs"}});
}

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// /odom comes from the process world+base, /tracks from rest, /local_plan from planning.
TEST(Split, RecordsWhatAllProcessesSay) {
  const Folder folder;
  split(folder, {"--for", "7", "--record", folder / "drive.mcap", "--compression=none"});
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
TEST(Split, EndsAllWhenOneCannotBegin) {
  const Folder folder;
  std::ofstream(folder / "drive.mcap") << "of yesterday";
  const Outcome outcome = split(folder, {"--for", "600", "--record", folder / "drive.mcap"});
  EXPECT_NE(outcome.status, -1) << "still ran after a minute";
  EXPECT_NE(outcome.status, 0);
  EXPECT_THAT(outcome.err, HasSubstr("drive.mcap"));
  EXPECT_EQ(text_of(folder / "drive.mcap"), "of yesterday");
}

// As the program takes them. The page is a process of its own: one that was asked for by --set=... was not
// started.
TEST(Split, TakesItsOptionsWithAnEqualsSignToo) {
  const Folder folder;
  split(folder, {"--for=3", "--set=viewer.enabled=true", "--set=viewer.port=0"});
  EXPECT_THAT(text_of(folder / "logs" / "manifest.yaml"), HasSubstr("viewer: exit status"));
  EXPECT_THAT(text_of(folder / "logs" / "viewer.out"), HasSubstr("?token="));
  for (const auto& log : std::filesystem::recursive_directory_iterator(folder / "logs"))
    EXPECT_EQ(log.status().permissions() & std::filesystem::perms(077), std::filesystem::perms::none) << log;
}

// The first process asks for the end while the second one is not started yet: nobody is left behind. In place
// of the program a script that has three processes and notes who ran.
TEST(Split, EndsWhatItStartsWhileItIsAskedToEnd) {
  const Folder folder;
  const std::filesystem::path program = folder / "program";
  std::ofstream(program) << "#!/bin/sh\n"
                            "[ $1 = graph ] && printf 'a\\nb\\nc\\n'\n"
                            "[ $1 = run ] || exit 0\n"
                            "echo $$ >>"
                         << (folder / "ran")
                         << "\n"
                            "[ $4 = a ] && kill -INT $PPID\n"
                            "exec tail -f /dev/null\n";
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const std::string root = BANDWAGON_SOURCE_DIR;
  const Outcome outcome = run_to_end(
      {root + "/launch_scripts/split.sh", root + "/config/graphs/hallway.yaml"}, std::chrono::seconds(60),
      {{"BANDWAGON_PROGRAM", program}, {"BANDWAGON_LOG_DIR", folder / "logs"}});
  EXPECT_NE(outcome.status, -1) << "still ran after a minute";
  std::ifstream ran(folder / "ran");
  int processes = 0;
  for (pid_t id = 0; ran >> id; ++processes) EXPECT_NE(kill(id, 0), 0) << id << " was left behind";
  EXPECT_GE(processes, 1);
}

TEST(Split, RefusesAPageOfOneProcessAlone) {
  const Folder folder;
  const Outcome outcome = split(folder, {"--html", folder / "drive.html"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--record FILE"));
  EXPECT_FALSE(std::filesystem::exists(folder / "logs"));
}

}  // namespace
}  // namespace bw::test
