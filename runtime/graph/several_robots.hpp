// Several robots from one list of components: each robot gets those that are not shared, under its own names.
#pragma once

#include <vector>

#include "runtime/graph/graph.hpp"

namespace bw {

/// Puts, in the place of every component that is not in `shared`, one for each robot of the section `robots:`
/// - node, topics, process and lane under the robot's name, its parameters over those of the component.
/// Nothing when `robots` is null.
void give_to_robots(Graph& graph, const ConfigNode* robots, const std::vector<std::string>& shared,
                    std::vector<Violation>& violations);

}  // namespace bw
