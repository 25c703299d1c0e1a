// The flag --emulate of verbs that load a graph: short for --set emulate=true.
#pragma once

#include <string>
#include <vector>

namespace bw {

inline constexpr const char* kEmulateHelp =
    "Devices of the robot are emulated: firmware and cables, with the simulated world behind them";

inline std::vector<std::string> with_emulation(std::vector<std::string> overrides, bool emulate) {
  if (emulate) overrides.emplace_back("emulate=true");
  return overrides;
}

}  // namespace bw
