// Children a few at a time: order, statuses, estimate, and an end by a person.
#include "components/lab/shards/child_pool.hpp"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

#include "runtime/child_process.hpp"
#include "tests/folder.hpp"

namespace bw {
namespace {

using ::testing::ElementsAre;

ChildJob shell(const test::Folder& folder, const std::string& name, const std::string& script,
               std::vector<std::size_t> after = {}) {
  return {.name = name,
          .command = {"/bin/sh", "-c", script},
          .log = folder / ("logs/" + name + ".txt"),
          .after = std::move(after)};
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

const auto kNobodyInterrupts = [] { return false; };

TEST(ToldShare, IsThatOfTheLastLineThatTellsOne) {
  EXPECT_EQ(told_share(""), 0.0);
  EXPECT_EQ(told_share("no [x] [1/] [/2] [3/0]"), 0.0);
  EXPECT_EQ(told_share("[1/20] a\n[3/20] b\n"), 0.15);
  EXPECT_EQ(told_share("[3/20] row [x, y]\nwarning [half"), 0.15);
  EXPECT_EQ(told_share("[20/20]"), 1.0);
}

TEST(StatusInWords, NamesTheSignalThatKilledAChild) {
  EXPECT_EQ(status_in_words(3), "ended with status 3");
  EXPECT_EQ(status_in_words(128 + 6), "was killed by signal 6 (Aborted)");
  EXPECT_EQ(status_in_words(128 + 11), "was killed by signal 11 (Segmentation fault)");
  EXPECT_EQ(status_in_words(-1), "was not started");
}

TEST(ChildPool, TellsTheStatusesAndKeepsWhatWasPrinted) {
  const test::Folder folder;
  const std::vector<ChildJob> jobs = {
      shell(folder, "good", "echo out; echo err >&2"),
      shell(folder, "bad", "exit 3"),
      shell(folder, "killed", "kill -KILL $$"),
      {.name = "none", .command = {"/no/such/program"}, .log = folder / "none.txt"}};
  std::vector<std::string> ended;
  double last_share = 0.0;
  const auto statuses = run_children(jobs, 2, kNobodyInterrupts, [&](const ChildProgress& p) {
    if (p.job != nullptr) ended.push_back(p.job->name);
    last_share = p.share;
  });
  EXPECT_THAT(statuses, ElementsAre(0, 3, 137, 127));
  EXPECT_THAT(ended, ::testing::UnorderedElementsAre("good", "bad", "killed", "none"));
  EXPECT_EQ(last_share, 1.0);
  EXPECT_EQ(text_of(folder / "logs/good.txt"), "out\nerr\n");
}

// The second looks for what the first leaves, and runs though there is room for both at once.
TEST(ChildPool, StartsAJobAfterThoseItNeeds) {
  const test::Folder folder;
  const std::string file = (folder / "made").string();
  const std::vector<ChildJob> jobs = {shell(folder, "takes", "test -e " + file, {1}),
                                      shell(folder, "makes", "read line < /dev/null; : > " + file)};
  EXPECT_THAT(run_children(jobs, 4, kNobodyInterrupts, [](const ChildProgress&) {}), ElementsAre(0, 0));
}

// Each notes how many there are while it runs: a directory can be made by one only.
TEST(ChildPool, RunsNoMoreAtATimeThanIsAllowed) {
  const test::Folder folder;
  const std::string alone = "mkdir " + (folder / "busy").string() + " && rmdir " + (folder / "busy").string();
  std::vector<ChildJob> jobs;
  for (int i = 0; i < 5; ++i) jobs.push_back(shell(folder, std::to_string(i), alone));
  EXPECT_THAT(run_children(jobs, 1, kNobodyInterrupts, [](const ChildProgress&) {}),
              ElementsAre(0, 0, 0, 0, 0));
}

// `cat` of a terminal's end that never comes would run for ever.
TEST(ChildPool, EndsItsChildrenWhenAPersonDoes) {
  const test::Folder folder;
  const std::string fifo = (folder / "fifo").string();
  const std::vector<ChildJob> jobs = {
      shell(folder, "waits", "echo $$; mkfifo " + fifo + "; exec cat " + fifo),
      shell(folder, "never", "echo started")};
  const auto waits = [&] { return std::filesystem::exists(fifo); };
  const auto statuses = run_children(jobs, 1, waits, [](const ChildProgress&) {});
  EXPECT_EQ(statuses[1], -1);
  EXPECT_THAT(statuses[0], ::testing::AnyOf(128 + 2, 128 + 9));
  EXPECT_FALSE(std::filesystem::exists(folder / "logs/never.txt"));
  const std::string id = text_of(folder / "logs/waits.txt");
  EXPECT_FALSE(std::filesystem::exists("/proc/" + id.substr(0, id.find('\n'))));
}

}  // namespace
}  // namespace bw
