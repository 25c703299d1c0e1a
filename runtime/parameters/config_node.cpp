#include "runtime/parameters/config_node.hpp"

#include <algorithm>

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

std::filesystem::path resolve_path(const Location& where, const std::string& text) {
  if (where.file == kOverrideFile) return text;
  return (std::filesystem::path(where.file).parent_path() / text).lexically_normal();
}

}  // namespace bw
