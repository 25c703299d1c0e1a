// Child processes, a few at a time, each with its output in a file; and how far they are, by the lines
// "[done/all] ..." that they print.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace bw {

struct ChildJob {
  std::string name;
  std::vector<std::string> command;     ///< a path and its arguments
  std::filesystem::path log;            ///< what it prints; its folder is made
  double cost = 1.0;                    ///< [s] about, on one core: for the estimate
  std::vector<std::size_t> after = {};  ///< jobs that must have ended before it starts
};

struct ChildProgress {
  double elapsed = 0.0;           ///< [s]
  double share = 0.0;             ///< of the cost that is done
  double remaining = 0.0;         ///< [s], by how long the done part took
  std::size_t ended = 0;          ///< jobs
  const ChildJob* job = nullptr;  ///< that ended now; null: a look in between
  int status = 0;                 ///< of it
};

/// Runs all jobs, at most `at_once` at a time and earlier ones first. Returns their exit statuses (128 + the
/// signal that ended one; -1: not started), in the order of the jobs. The children end with this process.
/// Where `is_interrupted` becomes true they are asked to end, and no more are started. Throws
/// std::runtime_error where a child cannot be started.
std::vector<int> run_children(const std::vector<ChildJob>& jobs, int at_once,
                              const std::function<bool()>& is_interrupted,
                              const std::function<void(const ChildProgress&)>& progress);

/// The share that the last line "[3/20] ..." of a text tells: 0.15; 0 without one.
double told_share(const std::string& text);

}  // namespace bw
