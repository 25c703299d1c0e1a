// What changes in a graph when devices of its robot are emulated instead of real. Each component says itself
// what that is to it:
//
//   base_emulator:
//     enabled: false
//     emulation: {base: {enabled: true}}
//   world:
//     emulation: {laser: {remap: {scan: sim/scan}, parameters: {laser: {rate: 50}}}}
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/graph/names.hpp"
#include "runtime/parameters/config_node.hpp"

namespace bw {

struct Graph;

/// What is laid over a component while `device` is emulated.
struct EmulationChange {
  std::string device;  ///< section of the robot: base or laser
  std::optional<bool> enabled;
  ConfigNode parameters;  ///< a map or nothing
  std::vector<Remap> remaps;
};

/// Reads the key `emulation` of a component; remaps are read by `read_remaps`, as those of the component are.
std::vector<EmulationChange> read_emulation(const ConfigNode& map, const std::string& key,
                                            std::vector<Violation>& violations);

/// Emulates every device that has a driver with a cable, which is any but `none` and `simulated`: its `port`
/// becomes `emulator`, and the components change as they say. Throws ConfigError, located at `where`, when
/// there is none.
void emulate_devices(Graph& graph, const Location& where);

}  // namespace bw
