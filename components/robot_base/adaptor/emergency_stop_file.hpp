// A latched emergency stop in a file, so that a process that is started anew knows of it. The file is there
// as long as the stop is latched: what cannot be read is latched too.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "components/robot_base/emergency_stop.hpp"
#include "runtime/parameters/config_node.hpp"
#include "runtime/serial/background_jobs.hpp"

namespace bw {

std::string text_of(const EmergencyStop::Record& record);
/// Throws ConfigError naming the file and the line.
EmergencyStop::Record record_of(const ConfigNode& file);

class EmergencyStopFile {
 public:
  /// `complain` hears of what could not be written, on a thread of its own.
  EmergencyStopFile(std::filesystem::path path, std::function<void(const std::string&)> complain);

  /// What the process before left; nothing: it was released.
  std::optional<EmergencyStop::Record> read() const;
  /// Writes it, or removes the file when it is not latched; returns at once, as a card may take its time to
  /// write.
  void keep(const EmergencyStop::Record& record);
  /// Why nothing can be kept; nothing: it can, as far as is known before.
  std::optional<std::string> obstacle() const;

 private:
  void write();

  std::filesystem::path path_;
  std::function<void(const std::string&)> complain_;
  std::mutex mutex_;
  std::optional<EmergencyStop::Record> next_;  ///< guarded by mutex_; only the newest is written
  std::unique_ptr<BackgroundJobs> jobs_;       ///< from the first on; last: it ends before what it uses
};

}  // namespace bw
