// All that SLAM knows as the bytes of a file, and back. Byte by byte: graph_file.md.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "components/slam/slam.hpp"

namespace bw::slam {

inline constexpr std::uint32_t kGraphVersion = 3;

struct SavedGraph {
  Pose2 X_MW;  ///< in the map that was shown, of the first scan, which Slam counts from
  SlamState slam;
};

/// Same state, same bytes.
std::string graph_bytes(const SavedGraph& graph);

struct GraphReading {
  std::optional<SavedGraph> graph;
  std::string fault;  ///< why there is none: at which byte, what is there, what must be
};

/// `bytes` may be anything. Each number is finite and within its range, each index has something to point
/// to, and no list is longer than the bytes that are left: Slam can go on with what is returned, and
/// graph_bytes() gives the same bytes. Needs some two times their memory.
GraphReading read_graph(std::string_view bytes);

}  // namespace bw::slam
