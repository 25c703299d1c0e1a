// The section `processes` of a graph: what each process may take at most. `bandwagon launch` sets it for those that it starts, and
// writes it into units of systemd.
//
//   processes:
//     planning: {memory: 800MB, cpu: 1.5}    # cpu: in cores
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/parameters/config_node.hpp"

namespace bw {

struct ProcessLimits {
  std::optional<std::uint64_t> memory;  ///< [bytes]
  std::optional<double> cpu;            ///< [cores]
};

/// By process. `known`: the graph's. Adds what it refuses to `violations`.
[[nodiscard]] std::map<std::string, ProcessLimits> read_process_limits(const ConfigNode& section,
                                                                       const std::vector<std::string>& known,
                                                                       std::vector<Violation>& violations);

}  // namespace bw
