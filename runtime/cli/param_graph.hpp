// `bandwagon param ...` on a graph file: what its components' parameters are before anything runs.
#pragma once

#include <string>
#include <vector>

namespace bw::cli {

struct GraphParameters {
  std::string path;
  std::string component;  ///< or a section that components share, as robot; empty: all
  std::vector<std::string> set;
  bool all = false;  ///< else, of a whole graph, those that people turn first
};

/// Names, types, ranges, defaults, values set by the graph, and meaning.
void list_graph(const GraphParameters& asked);
/// Values in use, as YAML for the graph's parameters: sections.
void dump_graph(const GraphParameters& asked);

}  // namespace bw::cli
