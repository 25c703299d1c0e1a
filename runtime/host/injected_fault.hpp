// One fault of the graph, as its kind configured it against the components that there are.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/fault.hpp"
#include "runtime/graph/fault_settings.hpp"
#include "runtime/graph/graph.hpp"
#include "runtime/host/actor.hpp"

namespace bw {

struct InjectedFault {
  FaultSettings settings;
  std::unique_ptr<Fault> fault;
  struct Gate {
    std::string topic;  ///< absolute
    FaultSetup::ChangeBytes change;
    bool always = false, holds = false;
  };
  std::vector<Gate> gates;
  std::function<Duration(Duration since)> clock_error;
  FaultSetup::Step begin, end, step;  ///< may be empty
  bool is_of_a_process = false;       ///< it needs `bandwagon launch`
  std::vector<Actor*> of;             ///< the components that it is of
  std::string where;                  ///< in words: /scan, or of local_planner

  [[nodiscard]] FaultTick at(Time now, Time start) const;
};

struct FaultSurroundings {
  const Graph* graph;
  std::vector<Actor*> actors;  ///< all of the graph
  std::uint64_t seed = 1;
  bool is_lockstep = false;
  bool is_whole = true;  ///< false: of a part of a graph, or a replay, where others publish
};

/// Throws ConfigError with file, line, key, value and rule.
std::vector<std::unique_ptr<InjectedFault>> injected_faults(const FaultSurroundings& around);

/// What a kind takes, for people: its topics, and its parameters.
struct FaultDescription {
  std::vector<std::string> topics;
  bool is_of_component = false, is_of_a_process = false;
  ParameterReport parameters;
};
FaultDescription describe(const FaultKind& kind);

}  // namespace bw
