// Some components of a graph apart from the others.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "runtime/graph/graph.hpp"

namespace bw::replay {

/// Enables the named components, and no others. Throws std::runtime_error for a name that is not in the
/// graph.
void keep_only(Graph& graph, const std::vector<std::string>& names);

struct Ends {
  std::set<std::string> inputs;   ///< topics
  std::set<std::string> outputs;  ///< topics
};

/// What the enabled components declare, by their names. Throws ConfigError for parameters that break a rule.
std::map<std::string, Ends> ends_of(const Graph& graph);

}  // namespace bw::replay
