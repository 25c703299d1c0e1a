#include "components/lab/battery/loops.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <iostream>
#include <iterator>
#include <map>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/stat.h>
#include <unistd.h>

#include "components/lab/battery/launched.hpp"
#include "runtime/cli/signals.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/parameters/xdg_folder.hpp"

namespace bw {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::vector<std::string> names_in(const std::filesystem::path& folder, const std::string& part) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (name.find(part) != std::string::npos) names.push_back(entry.path().string());
  }
  std::ranges::sort(names);
  return names;
}

/// Those that a launch starts.
int count_processes(const std::string& graph) {
  std::set<std::string> names;
  for (const ComponentNode& node : load_graph(graph).components) {
    if (node.enabled) names.insert(node.process);
  }
  return static_cast<int>(names.size());
}

/// Who has another parent by now is waited for: the kernel takes its time.
bool is_gone(pid_t process) {
  const auto begin = Clock::now();
  while (kill(process, 0) == 0 && since(begin) < 5.0)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  return kill(process, 0) != 0;
}

/// Up, and ended again: what went wrong, empty if nothing did.
std::string loop_once(const LoopsOptions& options, int number, LoopsResult& result) {
  const std::filesystem::path folder = options.out / fmt::format("loop_{}", number);
  std::filesystem::remove_all(folder);
  const auto begin = Clock::now();
  Launched launched(options.graph, {"--stay"}, folder);
  if (!launched.says(" is up after ", count_processes(options.graph), 60.0))
    return "did not come up:\n" + launched.log();
  result.slowest_start = std::max(result.slowest_start, since(begin));
  const auto asked = Clock::now();
  const std::map<std::string, pid_t> processes = launched.processes();
  if (options.kill) {
    kill(launched.id(), SIGKILL);
    for (const auto& [name, id] : processes) kill(id, SIGKILL);
  } else {
    launched.interrupt();
  }
  const auto status = launched.wait(30.0);
  result.slowest_end = std::max(result.slowest_end, since(asked));
  if (!status) return "did not end:\n" + launched.log();
  const int wanted = options.kill ? 128 + SIGKILL : 0;
  if (*status != wanted) return fmt::format("ended with status {}:\n{}", *status, launched.log());
  for (const auto& [name, id] : processes) {
    if (!is_gone(id)) return fmt::format("process {} ({}) is still there", id, name);
  }
  std::filesystem::remove_all(folder);
  return {};
}

}  // namespace

std::vector<std::string> look_for_leftovers() {
  std::vector<std::string> names = names_in(xdg_folder("XDG_RUNTIME_DIR", ".local/state"), "launch_");
  for (const auto& more :
       {names_in("/dev/shm", "fast"), names_in(std::filesystem::temp_directory_path(), "bandwagon")})
    names.insert(names.end(), more.begin(), more.end());
  std::ranges::sort(names);
  return names;
}

std::vector<std::string> added(const std::vector<std::string>& before,
                               const std::vector<std::string>& after) {
  std::vector<std::string> more;
  std::ranges::set_difference(after, before, std::back_inserter(more));
  return more;
}

LoopsResult run_loops(const LoopsOptions& options) {
  LoopsResult result;
  cli::catch_interrupts();
  std::vector<std::string> before;
  for (int i = 1; i <= options.loops && !cli::interrupted(); ++i) {
    std::string trouble = loop_once(options, i, result);
    // The first one leaves the lock of this graph, which the next ones take.
    const std::vector<std::string> after = look_for_leftovers();
    if (i == 1) before = after;
    if (const auto left = added(before, after); !left.empty())
      trouble +=
          (trouble.empty() ? "left behind: " : "; left behind: ") + fmt::format("{}", fmt::join(left, ", "));
    ++result.loops;
    if (!trouble.empty()) ++result.failures;
    if (!trouble.empty() || i % 10 == 0)
      std::cout << fmt::format("[{}/{}] {}", i, options.loops, trouble.empty() ? "as it should be" : trouble)
                << std::endl;
  }
  return result;
}

}  // namespace bw
