#include "components/lab/shards/graph_text.hpp"

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>

#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

constexpr int kDeepest = 3;  // a map's YAML names a picture; a circle of files ends

std::string content_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void add(std::string& text, const ConfigNode& node, int depth);

/// What the file that this value names holds, and of one in YAML the files that it names in turn. Nothing
/// where the value names none.
void add_file(std::string& text, const ConfigNode& node, int depth) {
  if (node.scalar.empty() || depth >= kDeepest) return;
  const std::filesystem::path path = resolve_path(node.where, node.scalar);
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) return;
  text += " (" + std::to_string(std::hash<std::string>()(content_of(path))) + ")";
  if (path.extension() == ".yaml" || path.extension() == ".yml") add(text, load_yaml(path), depth + 1);
}

void add(std::string& text, const ConfigNode& node, int depth) {
  if (node.is_map()) {
    text += '{';
    for (const ConfigEntry& entry : node.map) {
      text += entry.key + ": ";
      add(text, entry.value, depth);
    }
    text += '}';
  } else if (node.is_sequence()) {
    text += '[';
    for (const ConfigNode& element : node.sequence) add(text, element, depth);
    text += ']';
  } else {
    text += node.quoted ? '"' + node.scalar + '"' : node.scalar;
    add_file(text, node, depth);
  }
  text += ", ";
}

}  // namespace

std::string text_of(const Graph& graph) {
  std::string text = content_of(graph.path);
  for (const auto& [name, section] : graph.shared) {
    text += "\n" + name + ": ";
    add(text, section, 0);
  }
  for (const ComponentNode& node : graph.components) {
    text += "\n" + node.name + " " + node.type + (node.enabled ? ": " : " left out: ");
    add(text, node.parameters, 0);
  }
  return text;
}

}  // namespace bw
