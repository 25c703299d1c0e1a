// A program that this process starts, looks after and ends.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <sys/types.h>

namespace bw {

struct ChildProcessOptions {
  std::vector<std::string> command;                     ///< a path and its arguments
  std::map<std::string, std::string> environment = {};  ///< over the own one
  std::filesystem::path log;  ///< what it prints on standard error; its folder is made
  bool keeps_output = true;   ///< standard output goes there too; else to the own standard error
  /// In place of the log: descriptors for its standard output and error.
  std::optional<std::pair<int, int>> outputs = std::nullopt;
  bool is_apart = false;  ///< in a process group of its own: a terminal's Ctrl-C does not reach it
};

class ChildProcess {
 public:
  /// It ends with this process, however that ends. Throws std::runtime_error; a path that is no program ends with
  /// status 127.
  explicit ChildProcess(const ChildProcessOptions& options);
  /// Asks it to end, and kills it after a second.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Its exit status, or 128 + the signal that ended it; nothing while it runs.
  std::optional<int> status();
  /// The same, as it was when it was last asked.
  [[nodiscard]] std::optional<int> known_status() const { return status_; }
  void signal(int number) const;
  [[nodiscard]] pid_t id() const { return id_; }

 private:
  pid_t id_ = -1;
  std::optional<int> status_;
};

/// Of a status: "ended with status 3", "was killed by signal 6 (Aborted)"; below 0 "was not started".
std::string status_in_words(int status);

/// The end of what a child printed, 500 bytes at most.
std::string last_words(const std::filesystem::path& log);

}  // namespace bw
