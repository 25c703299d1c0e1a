#include "runtime/parameters/config_node.hpp"

#include <algorithm>
#include <utility>

#include "runtime/parameters/scalar_text.hpp"

namespace bw {

const ConfigNode* ConfigNode::find(std::string_view key) const {
  const auto entry =
      std::find_if(map.begin(), map.end(), [key](const ConfigEntry& e) { return e.key == key; });
  return entry == map.end() ? nullptr : &entry->value;
}

ConfigNode* ConfigNode::find(std::string_view key) {
  const auto entry =
      std::find_if(map.begin(), map.end(), [key](const ConfigEntry& e) { return e.key == key; });
  return entry == map.end() ? nullptr : &entry->value;
}

std::string ConfigNode::text() const {
  switch (kind) {
    case Kind::kNull:
      return "nothing";
    case Kind::kScalar:
      return quoted ? '"' + scalar + '"' : scalar;
    case Kind::kSequence:
      return "a list";
    case Kind::kMap:
      return "a map";
  }
  return {};
}

const ConfigNode* find_dotted(const ConfigNode& root, std::string_view key) {
  const ConfigNode* node = &root;
  while (node != nullptr) {
    const std::size_t dot = key.find('.');
    const std::string_view part = key.substr(0, dot);
    if (node->is_sequence()) {
      const std::optional<std::int64_t> index = parse_integer(part);
      const bool exists = index && *index >= 0 && std::cmp_less(*index, node->sequence.size());
      node = exists ? &node->sequence[static_cast<std::size_t>(*index)] : nullptr;
    } else {
      node = node->find(part);
    }
    if (dot == std::string_view::npos) break;
    key.remove_prefix(dot + 1);
  }
  return node;
}

std::filesystem::path resolve_path(const Location& where, const std::string& text) {
  if (where.file == kOverrideFile) return text;
  return (std::filesystem::path(where.file).parent_path() / text).lexically_normal();
}

}  // namespace bw
