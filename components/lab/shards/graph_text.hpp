// What a graph does, as text: two graphs with the same text drive alike.
#pragma once

#include <string>

#include "runtime/graph/graph.hpp"

namespace bw {

/// The file, and components, parameters and shared sections as they are after all overrides, with the content
/// of the files that they name (maps and their pictures, tables). Not where they were written, so that a
/// project that was moved is the same one.
std::string text_of(const Graph& graph);

}  // namespace bw
