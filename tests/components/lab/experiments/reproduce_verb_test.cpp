// `bandwagon reproduce` as a person runs it: killed in the middle and run again, and its exit status.
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "components/viewer/adaptor/site.hpp"
#include "tests/folder.hpp"
#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

using testing::HasSubstr;
using testing::Not;

constexpr auto kLimit = std::chrono::seconds(200);

std::vector<std::string> reproduce(const std::string& subject, const std::filesystem::path& out,
                                   const std::vector<std::string>& more = {}) {
  std::vector<std::string> command = {BANDWAGON_PROGRAM, "reproduce", subject,
                                      "--quick",         "--out",     out.string()};
  command.insert(command.end(), more.begin(), more.end());
  return command;
}

/// Every file below the folder with its content.
std::map<std::string, std::string> files_in(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  if (!std::filesystem::exists(folder)) return files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".json") continue;  // one that is being written
    std::ifstream in(entry.path(), std::ios::binary);
    files[entry.path().filename()] = {std::istreambuf_iterator<char>(in), {}};
  }
  return files;
}

// A quick run has two drives of each of five pairs in two hallways; a shard 1/10 of it the first one in each
// hallway.
TEST(ReproduceVerb, GoesOnWhereItWasKilled) {
  const Folder folder;
  const auto kept = folder / "navigation/kept";
  const std::vector<std::string> command =
      reproduce("navigation", folder / "navigation", {"--simulated-drivers", "--shard", "1/10"});
  {
    Process killed(command);
    ASSERT_TRUE(poll_until(std::chrono::steady_clock::now() + kLimit, std::chrono::milliseconds(5), [&] {
      return !files_in(kept).empty();
    })) << killed.err();
    killed.signal(SIGKILL);
    EXPECT_EQ(killed.wait(kLimit), 128 + SIGKILL);
  }
  const auto before = files_in(kept);
  ASSERT_EQ(before.size(), 1U);
  const auto written = std::filesystem::last_write_time(kept / before.begin()->first);

  const Outcome again = run_to_end(command, kLimit);
  EXPECT_EQ(again.status, 0) << again.err;
  EXPECT_THAT(again.err, testing::ContainsRegex("\\[1/2\\] Eddie edwa, hallway light[^\n]*, kept"));
  EXPECT_THAT(again.err, HasSubstr("[2/2] Eddie edwa, hallway full"));
  EXPECT_THAT(again.err, Not(testing::ContainsRegex("\\[2/2\\][^\n]*, kept")));
  const auto after = files_in(kept);
  ASSERT_EQ(after.size(), 2U);
  EXPECT_EQ(std::filesystem::last_write_time(kept / before.begin()->first), written);  // not driven twice
  EXPECT_EQ(after.at(before.begin()->first), before.begin()->second);
  // A shard makes no page.
  EXPECT_FALSE(std::filesystem::exists(folder / "navigation/index.html"));
}

// Ten and five seeds can be off by anything: nothing that a quick run finds so is a failure.
TEST(ReproduceVerb, AQuickRunJudgesOnlyWhatFewSeedsShow) {
  const Folder folder;
  for (const char* subject : {"ekf", "pf", "edwa"}) {
    const Outcome run = run_to_end(reproduce(subject, folder / subject), kLimit, {{"BANDWAGON_SHARED", ""}});
    EXPECT_EQ(run.status, 0) << subject << run.out << run.err;
    EXPECT_THAT(run.out, HasSubstr("not judged, "));
    const nlohmann::json json =
        nlohmann::json::parse(std::ifstream(folder / (std::string(subject) + "/results.json")));
    EXPECT_TRUE(json["made_by"]["quick"].get<bool>());
    EXPECT_FALSE(json["published"].empty());
    EXPECT_TRUE(json["criteria"][0]["met"].is_null());
    EXPECT_EQ(std::filesystem::exists(folder / (std::string(subject) + "/index.html")),
              !viewer::report_files().empty());
  }
}

TEST(ReproduceVerb, RefusesAShardThatIsNone) {
  const Folder folder;
  for (const char* shard : {"0/2", "3/2", "1", "a/b", "1/0", "-1/2", "1/2x"}) {
    const Outcome run = run_to_end(reproduce("navigation", folder / "out", {"--shard", shard}), kLimit);
    EXPECT_EQ(run.status, 2) << shard;
    EXPECT_THAT(run.err, HasSubstr("--shard")) << shard;
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace bw::test
