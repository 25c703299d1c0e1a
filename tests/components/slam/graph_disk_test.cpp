// Graphs on disk: the last good file stays, whatever happens to the next.
//
//   BANDWAGON_GRAPH_KILLS=100 test_slam_graph_disk --gtest_filter=GraphDisk.KilledWhileSaving*
#include "components/slam/files/graph_disk.hpp"

#include <array>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/components/slam/graph_samples.hpp"
#include "tests/folder.hpp"

namespace bw::slam {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string refusal(const std::filesystem::path& path) {
  try {
    read_graph_file(path);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "read";
}

SavedGraph sample() { return *read_graph(test::small_graph()).graph; }

TEST(GraphDisk, WritesAndReads) {
  const bw::test::Folder folder;
  write_graph_file(folder / "a.posegraph", sample());
  EXPECT_EQ(content_of(folder / "a.posegraph"), test::small_graph());
  EXPECT_EQ(graph_bytes(read_graph_file(folder / "a.posegraph")), test::small_graph());
}

TEST(GraphDisk, SaysWhichFileAndWhy) {
  const bw::test::Folder folder;
  EXPECT_THAT(refusal(folder / "none.posegraph"),
              AllOf(HasSubstr("none.posegraph"), HasSubstr("No such file")));
  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("/dev/zero: it is no file"));
  std::ofstream(folder / "cut.posegraph", std::ios::binary) << test::small_graph().substr(0, 5000);
  EXPECT_THAT(refusal(folder / "cut.posegraph"),
              AllOf(HasSubstr("cut.posegraph: byte 12: size: "), HasSubstr("the file has 5000 bytes")));
  EXPECT_THROW(write_graph_file(folder / "no" / "a.posegraph", sample()), std::runtime_error);
}

// What reading refuses is not written over what can be read.
TEST(GraphDisk, KeepsTheLastGoodFile) {
  const bw::test::Folder folder;
  write_graph_file(folder / "a.posegraph", sample());
  SavedGraph bad = sample();
  bad.slam.closing.X_MS.back().x = 1e9;
  EXPECT_THROW(write_graph_file(folder / "a.posegraph", bad), std::runtime_error);
  EXPECT_EQ(content_of(folder / "a.posegraph"), test::small_graph());
}

// A limit on the size of files stands for a disk without room.
TEST(GraphDisk, KeepsItWhenTheDiskIsFull) {
  const bw::test::Folder folder;
  write_graph_file(folder / "a.posegraph", sample());
  SavedGraph other = sample();
  other.X_MW = {};
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit small{4096, 4096};
    setrlimit(RLIMIT_FSIZE, &small);
    try {
      write_graph_file(folder / "a.posegraph", other);
    } catch (const std::runtime_error&) {
      _exit(7);
    }
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  EXPECT_EQ(content_of(folder / "a.posegraph"), test::small_graph());
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / ""), {}), 1) << "no draft is left";
}

/// Saves one and the other in turn until it is killed; a byte goes into `pipe` before each.
[[noreturn]] void save_until_killed(const std::filesystem::path& path,
                                    const std::array<SavedGraph, 2>& graphs, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (std::size_t i = 0;; ++i) {
    if (::write(pipe, "", 1) != 1) _exit(1);
    write_graph_file(path, graphs[i % 2]);
  }
}

TEST(GraphDisk, KilledWhileSavingItLeavesTheOldOrTheNew) {
  const char* asked = std::getenv("BANDWAGON_GRAPH_KILLS");
  const int kills = asked == nullptr ? 10 : std::atoi(asked);
  const bw::test::Folder folder;
  const std::filesystem::path path = folder / "a.posegraph";
  std::array<SavedGraph, 2> graphs{sample(), sample()};
  graphs[1].X_MW = {};
  const std::array<std::string, 2> bytes{graph_bytes(graphs[0]), graph_bytes(graphs[1])};
  write_graph_file(path, graphs[1]);
  std::mt19937_64 random(1);
  std::array<int, 2> left{};
  for (int k = 0; k < kills; ++k) {
    std::array<int, 2> pipe{};
    ASSERT_EQ(::pipe(pipe.data()), 0);
    const pid_t child = fork();
    if (child == 0) {
      close(pipe[0]);
      save_until_killed(path, graphs, pipe[1]);
    }
    close(pipe[1]);
    char byte = 0;
    for (std::uint64_t n = 1 + random() % 4; n > 0; --n) ASSERT_EQ(::read(pipe[0], &byte, 1), 1);
    // Somewhere in the saving that has begun.
    volatile std::uint64_t spent = 0;
    for (std::uint64_t n = random() % 20'000'000; n > 0; --n) spent = spent + 1;
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    close(pipe[0]);
    const std::string content = content_of(path);
    ASSERT_TRUE(content == bytes[0] || content == bytes[1]) << "kill " << k;
    ++left[content == bytes[1] ? 1 : 0];
  }
  std::printf("%d kills while saving: %d times one graph, %d times the other, never anything else\n", kills,
              left[0], left[1]);
}

}  // namespace
}  // namespace bw::slam
