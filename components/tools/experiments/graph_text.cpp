#include "components/tools/experiments/graph_text.hpp"

#include <fstream>
#include <iterator>

namespace bw {
namespace {

void add(std::string& text, const ConfigNode& node) {
  if (node.is_map()) {
    text += '{';
    for (const ConfigEntry& entry : node.map) {
      text += entry.key + ": ";
      add(text, entry.value);
    }
    text += '}';
  } else if (node.is_sequence()) {
    text += '[';
    for (const ConfigNode& element : node.sequence) add(text, element);
    text += ']';
  } else {
    text += node.quoted ? '"' + node.scalar + '"' : node.scalar;
  }
  text += ", ";
}

}  // namespace

std::string text_of(const Graph& graph) {
  std::ifstream file(graph.path, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(file), {});
  for (const auto& [name, section] : graph.shared) {
    text += "\n" + name + ": ";
    add(text, section);
  }
  for (const ComponentNode& node : graph.components) {
    text += "\n" + node.name + " " + node.type + (node.enabled ? ": " : " left out: ");
    add(text, node.parameters);
  }
  return text;
}

}  // namespace bw
