#include "runtime/graph/names.hpp"

#include <algorithm>

#include "runtime/parameters/read_parameters.hpp"

namespace bw {
namespace {

constexpr std::size_t kLongestTopic = 247;  // rmw: 255 minus the longest prefix
constexpr std::size_t kLongestNamespace = 245;
constexpr std::size_t kLongestNode = 255;

bool is_token(std::string_view token) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
  };
  return !token.empty() && !(token[0] >= '0' && token[0] <= '9') &&
         std::all_of(token.begin(), token.end(), is_allowed);
}

bool are_tokens(std::string_view path) {
  for (std::size_t start = 0;;) {
    const std::size_t slash = path.find('/', start);
    if (!is_token(path.substr(start, slash == std::string_view::npos ? slash : slash - start))) return false;
    if (slash == std::string_view::npos) return true;
    start = slash + 1;
  }
}

std::string too_long(std::size_t longest) {
  return "must be at most " + std::to_string(longest) + " characters long";
}

/// Absolute, without remaps.
std::string expand(std::string_view node_namespace, std::string_view node, std::string_view name) {
  if (name == "~") return join_namespaces(node_namespace, node);
  if (name.starts_with("~/")) return join_namespaces(join_namespaces(node_namespace, node), name.substr(2));
  if (name.starts_with("../")) {
    const std::size_t last = node_namespace.rfind('/');
    return join_namespaces(node_namespace.substr(0, std::max<std::size_t>(last, 1)), name.substr(3));
  }
  return join_namespaces(node_namespace, name);
}

}  // namespace

std::vector<Remap> read_remaps(const ConfigNode& map, const std::string& key,
                               std::vector<Violation>& violations) {
  std::vector<Remap> remaps;
  if (!is_section(map, key, violations)) return remaps;
  for (const ConfigEntry& entry : map.map) {
    const std::string entry_key = joined(key, entry.key);
    Remap remap{entry.key, "", entry.where};
    const std::size_t before = violations.size();
    read_value(entry.value, entry_key, {}, remap.to, violations);
    if (violations.size() > before) continue;
    if (const auto rule = topic_name_rule(remap.from))
      violations.push_back({entry.where, entry_key, "", *rule});
    if (const auto rule = topic_name_rule(remap.to))
      violations.push_back({entry.value.where, entry_key, entry.value.text(), *rule});
    remaps.push_back(std::move(remap));
  }
  return remaps;
}

std::optional<std::string> node_name_rule(std::string_view name) {
  if (name.size() > kLongestNode) return too_long(kLongestNode);
  if (!is_token(name)) return "must be a node name: letters, digits and _, no digit first";
  return std::nullopt;
}

std::optional<std::string> topic_name_rule(std::string_view name) {
  if (name.size() > kLongestTopic) return too_long(kLongestTopic);
  std::string_view path = name;
  if (path.starts_with("~/")) {
    path.remove_prefix(2);
  } else if (path.starts_with("../")) {
    path.remove_prefix(3);
  } else if (path.starts_with('/')) {
    path.remove_prefix(1);
  }
  if (!are_tokens(path))
    return "must be a topic name: letters, digits and _ between single /, no digit after a /";
  return std::nullopt;
}

std::optional<std::string> namespace_rule(std::string_view name) {
  if (name.empty() || name == "/") return std::nullopt;
  if (name.size() > kLongestNamespace) return too_long(kLongestNamespace);
  if (name.starts_with('/')) name.remove_prefix(1);
  if (!are_tokens(name))
    return "must be a namespace: letters, digits and _ between single /, no digit after a /";
  return std::nullopt;
}

std::string join_namespaces(std::string_view outer, std::string_view inner) {
  std::string joined;
  if (!inner.starts_with('/')) {
    if (!outer.starts_with('/')) joined += '/';
    joined += outer;
  }
  if (!inner.empty()) {
    if (!joined.empty() && !joined.ends_with('/')) joined += '/';
    joined += inner;
  }
  while (joined.size() > 1 && joined.ends_with('/')) joined.pop_back();
  return joined;
}

std::string_view without_action_part(std::string_view name) { return name.substr(0, name.find("/_action/")); }

std::string resolve_name(std::string_view node_namespace, std::string_view node, std::string_view name,
                         const std::vector<Remap>& remaps) {
  const std::string_view action = without_action_part(name);
  if (action != name)
    return resolve_name(node_namespace, node, action, remaps) + std::string(name.substr(action.size()));
  std::string topic = expand(node_namespace, node, name);
  for (const Remap& remap : remaps) {
    if (expand(node_namespace, node, remap.from) == topic) return expand(node_namespace, node, remap.to);
  }
  return topic;
}

}  // namespace bw
