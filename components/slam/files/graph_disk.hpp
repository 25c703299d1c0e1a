// Pose graphs on disk.
#pragma once

#include <filesystem>

#include "components/slam/graph_file.hpp"

namespace bw::slam {

/// Throws std::runtime_error naming the path and, of a file that is no graph of this version, the byte,
/// what is there and the rule (graph_file.hpp).
SavedGraph read_graph_file(const std::filesystem::path& path);

/// The file appears whole or not at all: until then one of that name stays as it is. What could not be read
/// again is not written. Throws std::runtime_error naming the path and the reason: no folder, no room, a
/// rule.
void write_graph_file(const std::filesystem::path& path, const SavedGraph& graph);

}  // namespace bw::slam
