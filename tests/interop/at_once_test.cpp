// Participants that are made at the same moment, as of a graph in several processes at boot: Fast DDS numbers
// them by the ports that it finds free, and processes may find the same one. Expected: all come up, and each
// hears and sees every other.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <list>
#include <string>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include "tests/interop/eventually.hpp"
#include "tests/interop/process.hpp"

namespace bw::test {
namespace {

TEST(AtOnce, SixteenParticipantsOfEightProcessesHearEachOther) {
  constexpr int kProcesses = 8, kRounds = 3;
  const std::string gate = std::filesystem::path(std::getenv("TEST_TMPDIR")) / "gate";
  std::ofstream{gate};
  for (int round = 0; round < kRounds; ++round) {
    const int file = open(gate.c_str(), O_RDONLY | O_CLOEXEC);
    ASSERT_EQ(flock(file, LOCK_EX), 0);
    std::list<Process> processes;
    for (int i = 0; i < kProcesses; ++i)
      processes.emplace_back(std::vector<std::string>{AT_ONCE, gate, std::to_string(2 * kProcesses)});
    const auto all_said = [&](const char* text) {
      return eventually(
          [&] { return std::ranges::all_of(processes, [&](const Process& p) { return p.out() == text; }); });
    };
    EXPECT_TRUE(all_said("ready\n"));
    close(file);
    EXPECT_TRUE(all_said("ready\ncomplete\n"));
    for (Process& process : processes) {
      if (process.out() != "ready\ncomplete\n") ADD_FAILURE() << process.out() << process.err();
      process.signal(SIGTERM);
      process.wait(std::chrono::seconds(10));
    }
  }
}

}  // namespace
}  // namespace bw::test
