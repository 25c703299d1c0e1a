// A configuration as a tree that remembers where each value was written. Built by yaml_file.hpp, changed by
// overrides.hpp.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/parameters/config_error.hpp"

namespace bw {

struct ConfigEntry;

struct ConfigNode {
  enum class Kind { kNull, kScalar, kSequence, kMap };

  Kind kind = Kind::kNull;
  std::string scalar;
  bool quoted = false;  ///< a quoted scalar is text, never a number
  std::vector<ConfigNode> sequence;
  std::vector<ConfigEntry> map;  ///< in the order written, keys unique
  Location where;

  /// The value of `key` in a map; nullptr if it has none or this is no map.
  const ConfigNode* find(std::string_view key) const;
  ConfigNode* find(std::string_view key);

  bool is_null() const { return kind == Kind::kNull; }
  bool is_scalar() const { return kind == Kind::kScalar; }
  bool is_sequence() const { return kind == Kind::kSequence; }
  bool is_map() const { return kind == Kind::kMap; }

  /// The value as messages show it: the scalar, or "a list", "a map", "nothing".
  std::string text() const;
};

struct ConfigEntry {
  std::string key;
  Location where;
  ConfigNode value;
};

/// The value of a dotted key, list elements by index (walls.0.x); nullptr if it is not given.
const ConfigNode* find_dotted(const ConfigNode& root, std::string_view key);

/// A path written at `where`: relative to that file's folder, or to the current folder if it was given by
/// --set.
std::filesystem::path resolve_path(const Location& where, const std::string& text);

}  // namespace bw
