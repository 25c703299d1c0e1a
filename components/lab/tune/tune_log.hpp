// Every drive of a tuning, a line each as it is done, so that one that was killed goes on.
#pragma once

#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "components/lab/tune/tune_suite.hpp"

namespace bw::tune {

class TuneLog {
 public:
  /// `head`: what all drives depend on, as one line. Throws std::runtime_error where the file is of another tuning, or
  /// cannot be written. A last line that was cut is driven again.
  TuneLog(const std::filesystem::path& file, const std::string& head);

  std::optional<TuneDrive> find(std::size_t candidate, std::uint64_t episode) const;
  void add(std::size_t candidate, std::uint64_t episode, const TuneDrive& drive);
  std::size_t size() const { return drives_.size(); }

 private:
  std::map<std::pair<std::size_t, std::uint64_t>, TuneDrive> drives_;
  std::ofstream out_;
  mutable std::mutex mutex_;
};

}  // namespace bw::tune
