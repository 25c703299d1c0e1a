// Changes of a graph by a command line, such as local_planner.algorithm=teb, robot=kobuki and emulate=true.
#include <utility>

#include "runtime/graph/config_file.hpp"
#include "runtime/graph/emulation.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/graph/graph_reading.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/read_parameters.hpp"
#include "runtime/parameters/yaml_file.hpp"

namespace bw {
namespace {

/// Switches the component on or off, or puts it into another process; false when the override means something else.
bool switch_component(ComponentNode& node, const Override& change) {
  if (change.path.size() != 2) return false;
  std::vector<Violation> violations;
  if (change.path.back() == "enabled") {
    read_value(change.value, change.key(), {}, node.enabled, violations);
  } else if (change.path.back() == "process") {
    read_value(change.value, change.key(), {}, node.process, violations);
    if (const auto rule = label_rule(node.process); rule && violations.empty())
      violations.push_back({change.value.where, change.key(), node.process, *rule});
  } else {
    return false;
  }
  throw_if_any(std::move(violations));
  return true;
}

/// A setting of the whole graph that a command line may change; false when the override means something else.
bool set_distro(Graph& graph, const Override& change) {
  if (change.path != std::vector<std::string>{"ros_distro"}) return false;
  std::vector<Violation> violations;
  read_value(change.value, change.key(), {}, graph.settings.ros_distro, violations);
  throw_if_any(std::move(violations));
  return true;
}

/// Of the files of a section that go by a name.
std::string folder_of(const std::string& section) { return section.ends_with('s') ? section : section + "s"; }

/// A whole shared section from a file: robot=FILE, where the command line stands, or robot=NAME. False when
/// the override means something else.
bool set_section(Graph& graph, const Override& change) {
  if (change.path.size() != 1 || !is_shared_section(change.path.front())) return false;
  if (!change.value.is_scalar())
    throw ConfigError(Violation{change.value.where, change.key(), change.value.text(), "must be a file"});
  ConfigNode section = load_yaml(std::filesystem::absolute(
      config_file(folder_of(change.path.front()), change.value.scalar, change.value.where)));
  if (!section.is_map())
    throw ConfigError(Violation{section.where, change.key(), section.text(), "must be a map of parameters"});
  graph.shared[change.path.front()] = std::move(section);
  return true;
}

/// Emulation, of the robot as it is by now. False when the override means something else.
bool set_emulation(Graph& graph, const Override& change) {
  if (!is_emulate(change)) return false;
  std::vector<Violation> violations;
  bool emulate = false;
  read_value(change.value, change.key(), {}, emulate, violations);
  throw_if_any(std::move(violations));
  if (emulate) emulate_devices(graph, change.value.where);
  return true;
}

/// The shared section that the first part of an override names.
ConfigNode& section_of(Graph& graph, const Override& change) {
  const std::string& name = change.path.front();
  std::vector<std::string_view> known(kSharedSections.begin(), kSharedSections.end());
  std::string rule;
  if (change.path.size() < 2) {
    rule = "must have the form component.param=value";
  } else if (is_shared_section(name)) {
    return graph.shared[name];
  } else {
    for (const ComponentNode& node : graph.components) known.push_back(node.name);
    rule = unknown_rule("component", name, known);
  }
  throw ConfigError(Violation{change.value.where, change.key(), change.value.text(), rule});
}

}  // namespace

void apply_override(Graph& graph, const Override& change) {
  if (set_distro(graph, change) || set_section(graph, change) || set_emulation(graph, change)) return;
  bool is_known = false;
  for (ComponentNode& node : graph.components) {
    if (change.path.size() < 2 || !is_meant(node, change.path.front())) continue;
    is_known = true;
    if (!switch_component(node, change)) apply_override(node.parameters, change, 1);
  }
  if (!is_known) apply_override(section_of(graph, change), change, 1);
}

}  // namespace bw
