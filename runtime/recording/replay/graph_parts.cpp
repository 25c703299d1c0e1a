#include "runtime/recording/replay/graph_parts.hpp"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "runtime/host/host.hpp"
#include "runtime/parameters/nearest.hpp"

namespace bw::replay {

void keep_only(Graph& graph, const std::vector<std::string>& names) {
  std::vector<std::string_view> known;
  for (const ComponentNode& node : graph.components) known.push_back(node.name);
  for (const std::string& name : names) {
    if (graph.find(name) == nullptr)
      throw std::runtime_error("--run " + name + ": " + unknown_rule("component", name, known));
  }
  for (ComponentNode& node : graph.components)
    node.enabled = std::ranges::find(names, node.name) != names.end();
}

std::map<std::string, Ends> ends_of(const Graph& graph) {
  const Host host(graph, {.clock = ClockMode::lockstep, .is_partial = true});
  std::map<std::string, Ends> ends;
  for (const ComponentDeclaration& declaration : host.declarations()) {
    const ComponentNode& node = *host.graph().find(declaration.name);
    Ends& own = ends[declaration.name];
    for (const InputDeclaration& input : declaration.inputs) own.inputs.insert(node.topic_of(input.name));
    for (const OutputDeclaration& output : declaration.outputs)
      own.outputs.insert(node.topic_of(output.name));
  }
  return ends;
}

}  // namespace bw::replay
