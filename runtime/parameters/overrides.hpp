// `--set component.param=value`: one value changed from the command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "runtime/parameters/config_node.hpp"

namespace bw {

struct Override {
  std::vector<std::string> path;  ///< the dotted name in parts, e.g. {"world", "walls", "0", "x"}
  ConfigNode value;               ///< located in kOverrideFile

  std::string key() const;  ///< dotted
};

/// "world.walls.0" in parts.
std::vector<std::string> parts_of(std::string_view dotted);

/// `text` is `dotted.name=value`, the value YAML as on the right side of a colon. Throws ConfigError.
Override parse_override(std::string_view text);

/// Sets `root[path[first]][...]...`, making sections as needed. A number addresses an element of a list that
/// the tree holds; the number after the last element appends. Throws ConfigError.
void apply_override(ConfigNode& root, const Override& change, std::size_t first = 0);

/// Lays `own` over `base`: maps are merged, everything else is replaced.
void put_over(ConfigNode& base, const ConfigNode& own);

}  // namespace bw
