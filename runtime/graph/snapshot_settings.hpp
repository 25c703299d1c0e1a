// The section `snapshot` of a graph: the last seconds are kept in memory, and written when something happens.
//
//   snapshot:
//     keep: 30s                     # of the time before an event
//     after: 30s                    # and of that behind it; default as keep. A further event prolongs it
//     memory: 256MB                 # at most; beyond it the oldest goes first
//     most: 20                      # snapshots of one run
//     to: ../../run/near_misses     # a folder, relative to this file; each snapshot becomes a bag in it
//     on:
//       - contact                   # an event that a component of the graph declares (BW_EVENT)
//       - /bumper                   # any message of a topic
//       - {name: empty, topic: /battery_state, field: percentage, below: 0.2}    # is, is_not, above, below, begins_with, rises
//
// or in one line: snapshot: {keep: 30s, on: [contact, stop, lost], to: ../../run/near_misses}
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/graph/event.hpp"
#include "runtime/parameters/config_node.hpp"

namespace bw {

struct SnapshotEvent {
  std::string name;                         ///< of a declared event, unless it says itself what it is
  std::optional<Event> own = std::nullopt;  ///< of a topic
  Location where;
};

struct SnapshotSettings {
  static constexpr std::uint64_t kLeastMemory = 1'000'000;  ///< [bytes]
  static constexpr Duration kLongest = Duration::milliseconds(3'600'000);
  static constexpr Duration kShortest = Duration::milliseconds(1000);

  Duration keep = Duration::milliseconds(30'000);
  std::optional<Duration> after;       ///< as keep, unless given
  std::uint64_t memory = 256'000'000;  ///< [bytes]
  std::int64_t most = 20;              ///< snapshots of one run
  std::vector<SnapshotEvent> on;       ///< empty: every event that components of the graph declare
  std::filesystem::path to = "snapshots";
  Location where;
};

/// Adds what it refuses to `violations`.
[[nodiscard]] SnapshotSettings read_snapshot(const ConfigNode& section, std::vector<Violation>& violations);

/// One entry of `on` in words: `contact` or `/bumper`.
[[nodiscard]] std::optional<SnapshotEvent> snapshot_event(const std::string& text, const Location& where,
                                                          const std::string& key,
                                                          std::vector<Violation>& violations);

}  // namespace bw
