// The processes of a graph as services of systemd.
#pragma once

#include <filesystem>
#include <vector>

#include "runtime/graph/graph.hpp"
#include "runtime/supervisor/supervisor.hpp"

namespace bw {

/// Writes into `folder` (made) bandwagon-GRAPH.target and for each process bandwagon-GRAPH-PROCESS.service, and says so.
/// Throws std::runtime_error.
void write_units(const std::filesystem::path& folder, const Graph& graph,
                 const std::vector<SupervisedProgram>& programs);

}  // namespace bw
