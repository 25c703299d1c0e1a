// A child process of a test: its output is kept, every wait is bounded, and it is ended by its own id, at the
// latest with this object or this test.
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace bw::test {

class Process {
 public:
  /// Starts `command` (a path and its arguments) with `environment` over the own one. Throws
  /// std::runtime_error.
  explicit Process(const std::vector<std::string>& command,
                   const std::map<std::string, std::string>& environment = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  pid_t id() const { return id_; }
  void signal(int number) const;
  bool running();
  /// The exit status, or 128 + the signal that ended it; nothing when it still runs after `limit`.
  std::optional<int> wait(std::chrono::milliseconds limit);
  /// What it printed so far.
  std::string out() const;
  std::string err() const;

 private:
  pid_t id_ = -1;
  int out_ = -1;
  int err_ = -1;
  std::optional<int> status_;
};

struct Outcome {
  int status = -1;  ///< -1: did not end in time and was killed
  std::string out;
  std::string err;
};

Outcome run_to_end(const std::vector<std::string>& command, std::chrono::milliseconds limit,
                   const std::map<std::string, std::string>& environment = {});

}  // namespace bw::test
