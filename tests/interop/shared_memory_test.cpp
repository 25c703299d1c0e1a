// Fast DDS 2.9.1 aborts beside other releases that use its shared-memory transport: a running process of ours
// has none of it, and leaves nothing behind.
#include <filesystem>
#include <set>

#include <gmock/gmock.h>

#include "tests/interop/running_graph.hpp"

namespace bw::test {
namespace {

std::set<std::string> shared_memory_files() {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator("/dev/shm"))
    names.insert(entry.path().filename());
  return names;
}

/// Of what the process maps and holds open, the parts in shared memory.
std::string in_shared_memory(pid_t process) {
  const std::filesystem::path proc = "/proc/" + std::to_string(process);
  std::string found;
  std::ifstream maps(proc / "maps");
  for (std::string line; std::getline(maps, line);) {
    if (line.find("/dev/shm/") != std::string::npos) found += line + "\n";
  }
  for (const auto& entry : std::filesystem::directory_iterator(proc / "fd")) {
    std::error_code gone;
    const std::string target = std::filesystem::read_symlink(entry, gone).string();
    if (target.starts_with("/dev/shm/")) found += target + "\n";
  }
  return found;
}

TEST(SharedMemory, ARunningProcessHasNoneAndLeavesNone) {
  const std::set<std::string> before = shared_memory_files();
  RunningGraph graph;
  // It answers on the wire: all of its transports are up.
  const Outcome echo =
      run_to_end({BANDWAGON_PROGRAM, "topic", "echo", "--once", "/odom"}, std::chrono::seconds(60));
  ASSERT_EQ(echo.status, 0) << echo.err << graph.process().err();
  EXPECT_EQ(in_shared_memory(graph.process().id()), "");
  EXPECT_EQ(graph.stop(), 0);
  // Others on this machine may come and go meanwhile: only what Fast DDS would leave counts.
  for (const std::string& name : shared_memory_files()) {
    if (before.contains(name)) continue;
    EXPECT_FALSE(name.starts_with("fast") || name.starts_with("sem.fast")) << "/dev/shm/" << name;
  }
}

}  // namespace
}  // namespace bw::test
