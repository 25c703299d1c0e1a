// A graph as a picture, in Graphviz's language: one cluster per process, one edge per topic and pair of ends.
#pragma once

#include <string>
#include <vector>

#include "runtime/graph/check_graph.hpp"

namespace bw {

/// Edges carry topic and type. Inputs without a publisher come from a node "outside". Dashed: best effort.
std::string to_dot(const std::vector<ComponentDeclaration>& declarations, const Graph& graph);

}  // namespace bw
