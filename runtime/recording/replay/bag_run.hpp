// Components of a graph run on what a bag holds for them, whether or not it holds what they wrote when it was
// recorded: for a look at other parameters, or at a recording of somebody else's robot.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "runtime/graph/graph.hpp"
#include "runtime/host/host.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw::replay {

struct BagRunOptions {
  std::vector<std::string> run;  ///< names of components of the graph
  /// Beside them: what stands in for what the bag lacks.
  std::vector<ExtraComponent> extra = {};
  /// Sees every message that the named components write, in order.
  std::function<void(const std::string& topic, Time now, std::span<const std::uint8_t> cdr)> on_output;
};

struct BagRunResult {
  std::uint64_t published = 0;     ///< messages of the bag
  std::uint64_t malformed = 0;     ///< that do not fit their type, left out
  std::vector<std::string> notes;  ///< damage of the bag; topics that are not what their type's name says
};

/// In lock-step, from the bag's first message to its last: same bag, same graph, same outputs. Only what the
/// named components read is played, in the order of the recording, and nothing that somebody here writes.
/// Throws ConfigError or std::runtime_error: a component that is not in the graph, an input nobody feeds.
BagRunResult run_on(const bag::Bag& recording, Graph graph, BagRunOptions options);

}  // namespace bw::replay
