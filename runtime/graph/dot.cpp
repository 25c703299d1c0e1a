#include "runtime/graph/dot.hpp"

#include <map>

namespace bw {
namespace {

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

std::string node_id(const ComponentNode& node) {
  return quoted(join_namespaces(node.node_namespace, node.node_name()));
}

}  // namespace

std::string to_dot(const std::vector<ComponentDeclaration>& declarations, const Graph& graph) {
  std::string out =
      "digraph " + quoted(graph.path.stem().string()) + " {\n  rankdir=LR;\n  node [shape=box];\n";
  int cluster = 0;
  for (const std::string& process : graph.processes()) {
    out += "  subgraph cluster_" + std::to_string(cluster++) + " {\n    label=" + quoted(process) + ";\n";
    for (const ComponentNode& node : graph.components) {
      if (node.process == process) out += "    " + node_id(node) + ";\n";
    }
    out += "  }\n";
  }

  std::multimap<std::string, std::string> writers_of;
  for (const ComponentDeclaration& declaration : declarations) {
    const ComponentNode* node = graph.find(declaration.name);
    if (node == nullptr) continue;
    for (const OutputDeclaration& output : declaration.outputs)
      writers_of.emplace(node->topic_of(output.name), node_id(*node));
  }
  std::string edges;
  bool has_outside = false;
  for (const ComponentDeclaration& declaration : declarations) {
    const ComponentNode* node = graph.find(declaration.name);
    if (node == nullptr) continue;
    for (const InputDeclaration& input : declaration.inputs) {
      const std::string topic = node->topic_of(input.name);
      std::string attributes = " [label=\"" + topic + "\\n" + input.type + "\"";
      if (input.qos.reliability == Reliability::best_effort) attributes += ", style=dashed";
      attributes += "];\n";
      const auto [first, last] = writers_of.equal_range(topic);
      for (auto writer = first; writer != last; ++writer) {
        edges += "  " + writer->second + " -> " + node_id(*node) + attributes;
      }
      if (first == last) {
        has_outside = true;
        edges += "  outside -> " + node_id(*node) + attributes;
      }
    }
  }
  if (has_outside) out += "  outside [shape=ellipse];\n";
  return out + edges + "}\n";
}

}  // namespace bw
