// What the command line says of recordings and snapshots.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/cli/bag_writing.hpp"
#include "runtime/cli/verb.hpp"
#include "runtime/graph/graph.hpp"

namespace bw {

struct RecordOptions {
  std::string record;
  cli::BagWriting writing;
  std::string snapshot;
  std::string snapshot_memory;
  std::string snapshot_to;
  std::vector<std::string> snapshot_on;

  void add_to(cli::Verb verb);
  /// Throws std::runtime_error naming option, value and rule.
  [[nodiscard]] bag::BagWriterOptions writer_options() const;
  /// Puts what was given over what the graph says. Throws std::runtime_error or ConfigError.
  void apply_to(std::optional<SnapshotSettings>& snapshot) const;
};

}  // namespace bw
