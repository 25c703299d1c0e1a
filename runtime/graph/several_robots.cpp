#include "runtime/graph/several_robots.hpp"

#include <algorithm>
#include <utility>

#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/read_parameters.hpp"

namespace bw {
namespace {

constexpr std::size_t kMaxComponents = 10'000;

/// Of a robot; one process for what names none.
std::string process_of(const std::string& robot, const std::string& process) {
  return process == "main" ? robot : robot + "-" + process;
}

ComponentNode of_robot(const ComponentNode& common, const ConfigEntry& robot,
                       const std::string& graph_namespace) {
  ComponentNode node = common;
  node.robot = robot.key;
  node.name = robot.key + "/" + common.name;
  node.process = process_of(robot.key, common.process);
  node.lane = robot.key + "-" + common.lane;
  if (!common.follows.empty()) node.follows = robot.key + "/" + common.follows;
  const std::string inner = common.node_namespace.substr(graph_namespace == "/" ? 0 : graph_namespace.size());
  node.node_namespace =
      join_namespaces(join_namespaces(graph_namespace, robot.key), inner.empty() ? inner : inner.substr(1));
  if (const ConfigNode* own = robot.value.find(common.name)) put_over(node.parameters, *own);
  return node;
}

bool is_below(const std::string& name, const std::string& outer) {
  return outer == "/" || name == outer || name.starts_with(outer + "/");
}

}  // namespace

void give_to_robots(Graph& graph, const ConfigNode* robots, const std::vector<std::string>& shared,
                    std::vector<Violation>& violations) {
  if (robots == nullptr || !is_section(*robots, "robots", violations)) return;
  const std::string outer = join_namespaces("", graph.settings.graph_namespace);
  const auto is_shared = [&](const std::string& name) {
    return std::ranges::find(shared, name) != shared.end();
  };
  std::vector<std::string_view> names;
  for (const ComponentNode& node : graph.components) {
    if (is_shared(node.name)) continue;
    names.push_back(node.name);
    if (!is_below(node.node_namespace, outer))
      violations.push_back({node.where, joined(joined("components", node.name), "namespace"),
                            node.node_namespace,
                            "must be relative where there are robots: each has this component"});
  }
  for (const ConfigEntry& robot : robots->map) {
    const std::string key = joined("robots", robot.key);
    if (const auto rule = node_name_rule(robot.key)) violations.push_back({robot.where, key, "", *rule});
    if (!is_section(robot.value, key, violations)) continue;
    for (const ConfigEntry& own : robot.value.map) {
      const bool is_known = std::ranges::find(names, own.key) != names.end();
      if (!is_known)
        violations.push_back({own.where, joined(key, own.key), "",
                              is_shared(own.key) ? "is one for all robots: its parameters stand with it"
                                                 : unknown_rule("component", own.key, names)});
      is_section(own.value, joined(key, own.key), violations);
    }
    graph.robots.push_back(robot.key);
  }
  if (graph.robots.size() * names.size() > kMaxComponents)
    violations.push_back({robots->where, "robots", "",
                          "must not make more than " + std::to_string(kMaxComponents) + " components"});
  if (!violations.empty() || graph.robots.empty()) return;
  std::vector<ComponentNode> all;
  for (const ComponentNode& node : graph.components) {
    if (is_shared(node.name)) {
      all.push_back(node);
      continue;
    }
    for (const ConfigEntry& robot : robots->map) all.push_back(of_robot(node, robot, outer));
  }
  graph.components = std::move(all);
}

}  // namespace bw
