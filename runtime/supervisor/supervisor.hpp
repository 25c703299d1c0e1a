// The processes of a graph, started, watched and ended together: `bandwagon launch`. The other end of
// NOTIFY_SOCKET (runtime/host/service_manager.hpp), where no systemd is. Nothing that stops the robot depends on it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/supervisor/supervised_process.hpp"
#include "runtime/supervisor/supervisor_lock.hpp"

namespace bw {

struct SupervisedProgram {
  std::string name;
  /// Of the start with this number, from 1 on: a path and its arguments.
  std::function<std::vector<std::string>(int start)> command;
  bool ends_last = false;                              ///< it hears the others: a recorder
  std::optional<std::uint64_t> memory = std::nullopt;  ///< [bytes] more it does not get (RLIMIT_DATA)
  std::optional<int> cores = std::nullopt;             ///< it runs on no more
};

struct SupervisorOptions {
  std::vector<SupervisedProgram> programs;
  std::filesystem::path logs;  ///< folder, which is there: NAME.out, NAME.log, and manifest.yaml, which grows
  SupervisionLimits limits = {};
  std::function<bool()> interrupted;  ///< asked often: whether to end
};

/// Where the supervisor of `what` is spoken to, in this user's runtime folder. Throws std::runtime_error where the
/// environment names none.
[[nodiscard]] std::filesystem::path supervisor_socket(const std::string& what);

/// Runs until all have ended: one by its own decision, by `interrupted`, by `stop`, or because one failed too often.
/// The worst of the last exit statuses of all, at least 1 where one was given up. Throws std::runtime_error where
/// nothing can be started.
int supervise(const SupervisorLock& lock, SupervisorOptions options);

/// One of `status`, `stop`, `restart`, `restart NAME`: the supervisor's answer. Throws std::runtime_error where none
/// answers. After `stop` it returns when the supervisor has ended.
std::string ask_supervisor(const std::filesystem::path& socket, const std::string& question);

}  // namespace bw
