// The section `faults` of a graph: what goes wrong in a run, when, and where; a map or a file (--set faults=FILE).
//
//   faults:
//     blind:                    # its name on /faults and in the diagnostics
//       kind: laser_silent      # default: the name; `bandwagon faults` lists them
//       from: 5s                # of the run; under `bandwagon launch` of the launch, which restarts do not set back
//       for: 3s                 # default: to the end
//       every: 30s              # again and again; default: once
//       topic: scan             # of a kind that is of any topic, or in place of the kind's own
//       of: local_planner       # component or process, for kinds that are of one: clock, process, parameters
//       namespace: robot1       # of its topics, below the graph's
//       enabled: true
//       parameters: {...}       # of the kind
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/base/time.hpp"
#include "runtime/parameters/config_node.hpp"

namespace bw {

struct FaultSettings {
  std::string name, kind;
  Duration from;
  std::optional<Duration> lasts;  ///< nothing: to the end
  std::optional<Duration> every;  ///< nothing: once
  std::string topic;              ///< empty: the kind's own
  std::string of;                 ///< empty: of none
  std::string node_namespace;
  ConfigNode parameters;
  Location where;

  /// Which time it acts, from 0 on, at this time of the run; nothing: it does not.
  [[nodiscard]] std::optional<std::int64_t> occurrence_at(Duration run) const;
  /// When an occurrence begins, in time of the run.
  [[nodiscard]] Duration beginning_of(std::int64_t occurrence) const;
};

/// Those that are enabled, in the order written. Adds what it refuses to `violations`.
[[nodiscard]] std::vector<FaultSettings> read_faults(const ConfigNode& section,
                                                     std::vector<Violation>& violations);

}  // namespace bw
