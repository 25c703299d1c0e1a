// ROS 2 names of nodes and topics: which are allowed, and how a relative one becomes absolute.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/parameters/config_node.hpp"

namespace bw {

/// One entry of `remap:`.
struct Remap {
  std::string from;  ///< as the component declares it
  std::string to;
  Location where;
};

/// The section `remap:` under `key`; what breaks a rule is left out and told.
std::vector<Remap> read_remaps(const ConfigNode& map, const std::string& key,
                               std::vector<Violation>& violations);

// Each returns the rule that `name` breaks, or nothing.

/// One token: letters, digits and _, no digit first.
std::optional<std::string> node_name_rule(std::string_view name);
/// Tokens joined by /, absolute or relative, private as ~/name, or of the namespace above as ../name;
/// absolute at most 247 characters long.
std::optional<std::string> topic_name_rule(std::string_view name);
/// As a topic name, but not private; empty or "/" is the root.
std::optional<std::string> namespace_rule(std::string_view name);

/// `inner` below `outer`, or `inner` itself if that is absolute. Absolute, without / at the end except for
/// the root "/".
std::string join_namespaces(std::string_view outer, std::string_view inner);

/// The action whose service or topic it is, or else `name` itself.
std::string_view without_action_part(std::string_view name);

/// The topic that a node means by `name`: /absolute, relative (below its namespace) or ~/private (below the
/// node). A remap applies if its `from` means the same topic; the first one wins, and it applies once. The
/// services and topics of an action go where the action goes.
std::string resolve_name(std::string_view node_namespace, std::string_view node, std::string_view name,
                         const std::vector<Remap>& remaps = {});

}  // namespace bw
