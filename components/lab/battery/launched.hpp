// `bandwagon launch` as a child of the lab, with its logs in a folder.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/child_process.hpp"

namespace bw {

/// The program `bandwagon` beside this one. Throws std::runtime_error where there is none.
std::filesystem::path robots_program();

class Launched {
 public:
  /// `words` after GRAPH. Throws std::runtime_error.
  Launched(const std::string& graph, std::vector<std::string> words, const std::filesystem::path& folder);

  /// Of launch.log, as it is now.
  [[nodiscard]] std::string log() const;
  /// Polls until `text` stands in it as often as that; false after `patience` [s], or when it has ended.
  bool says(const std::string& text, int times, double patience);
  /// Its exit status; nothing after `patience` [s].
  std::optional<int> wait(double patience);
  /// Asks it to end, as Ctrl-C does.
  void interrupt() const;
  [[nodiscard]] pid_t id() const { return process_->id(); }
  /// Those that it started, by name, as its manifest tells: of each the last start.
  [[nodiscard]] std::map<std::string, pid_t> processes() const;

 private:
  std::filesystem::path folder_;
  std::unique_ptr<ChildProcess> process_;
};

}  // namespace bw
