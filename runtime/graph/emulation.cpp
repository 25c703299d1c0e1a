#include "runtime/graph/emulation.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "runtime/graph/graph.hpp"
#include "runtime/parameters/nearest.hpp"
#include "runtime/parameters/overrides.hpp"
#include "runtime/parameters/read_parameters.hpp"

namespace bw {
namespace {

const std::vector<std::string_view> kDevices = {"base", "laser"};
constexpr std::array<std::string_view, 2> kWithoutCable = {"none", "simulated"};

/// The device of section `robot`, if there is a cable between it and its driver.
bool has_cable(const ConfigNode& robot, std::string_view device) {
  const ConfigNode* section = robot.find(device);
  const ConfigNode* driver = section == nullptr ? nullptr : section->find("driver");
  return driver != nullptr && driver->is_scalar() &&
         std::ranges::find(kWithoutCable, driver->scalar) == kWithoutCable.end();
}

void lay_over(ComponentNode& node, const EmulationChange& change) {
  if (change.enabled) node.enabled = *change.enabled;
  if (change.parameters.is_map()) put_over(node.parameters, change.parameters);
  // The first remap of a name is the one that applies.
  node.remaps.insert(node.remaps.begin(), change.remaps.begin(), change.remaps.end());
}

std::string driver_of(const ConfigNode& robot, std::string_view device) {
  const ConfigNode* section = robot.find(device);
  const ConfigNode* driver = section == nullptr ? nullptr : section->find("driver");
  return driver == nullptr ? "none" : driver->text();
}

}  // namespace

std::vector<EmulationChange> read_emulation(const ConfigNode& map, const std::string& key,
                                            std::vector<Violation>& violations) {
  std::vector<EmulationChange> changes;
  if (!is_section(map, key, violations)) return changes;
  for (const ConfigEntry& entry : map.map) {
    const std::string of_device = joined(key, entry.key);
    if (std::ranges::find(kDevices, entry.key) == kDevices.end())
      violations.push_back({entry.where, of_device, "", unknown_rule("device", entry.key, kDevices)});
    if (!is_section(entry.value, of_device, violations)) continue;
    ParameterReader reader(entry.value, of_device, violations);
    EmulationChange change{.device = entry.key, .enabled = {}, .parameters = {}, .remaps = {}};
    if (const ConfigNode* enabled = reader.find("enabled"))
      read_value(*enabled, joined(of_device, "enabled"), {}, change.enabled.emplace(), violations);
    const ConfigNode* parameters = reader.find("parameters");
    if (parameters != nullptr && is_section(*parameters, joined(of_device, "parameters"), violations))
      change.parameters = *parameters;
    if (const ConfigNode* remap = reader.find("remap"))
      change.remaps = read_remaps(*remap, joined(of_device, "remap"), violations);
    reader.refuse_unknown_keys();
    changes.push_back(std::move(change));
  }
  return changes;
}

void emulate_devices(Graph& graph, const Location& where) {
  ConfigNode& robot = graph.shared["robot"];
  std::vector<std::string_view> emulated;
  for (const std::string_view device : kDevices) {
    if (!has_cable(robot, device)) continue;
    emulated.push_back(device);
    ConfigNode port;
    port.kind = ConfigNode::Kind::kScalar;
    port.scalar = "emulator";
    port.where = where;
    apply_override(robot, Override{.path = {std::string(device), "port"}, .value = std::move(port)});
  }
  if (emulated.empty())
    throw ConfigError(Violation{
        where, "emulate", "true",
        "needs a robot with a device to emulate, as in --set robot=FILE: robot.base.driver is '" +
            driver_of(robot, "base") + "' and robot.laser.driver '" + driver_of(robot, "laser") + "'"});
  for (ComponentNode& node : graph.components) {
    for (const EmulationChange& change : node.emulation) {
      if (std::ranges::find(emulated, change.device) != emulated.end()) lay_over(node, change);
    }
  }
}

}  // namespace bw
