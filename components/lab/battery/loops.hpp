// A graph started and stopped again and again: does each loop come up and end as it should, and what is left behind.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace bw {

/// Names that a run may leave: sockets, shared memory, temporary files.
std::vector<std::string> look_for_leftovers();
/// Those of `after` that are not in `before`, both sorted.
std::vector<std::string> added(const std::vector<std::string>& before, const std::vector<std::string>& after);

struct LoopsOptions {
  std::string graph = "hallway";
  int loops = 1000;
  std::filesystem::path out = "loops";
  bool kill = false;  ///< ended by SIGKILL of all, supervisor included, in place of being asked
};

struct LoopsResult {
  int loops = 0, failures = 0;
  double slowest_start = 0.0;  ///< [s] until all are up
  double slowest_end = 0.0;    ///< [s] from being asked until all have ended
};

/// Says each failure, and goes on; `loops` less than asked where it was interrupted.
LoopsResult run_loops(const LoopsOptions& options);

}  // namespace bw
