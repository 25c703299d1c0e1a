// What of a connection graph changed, as connectionGraphUpdate tells it.
#pragma once

#include <string>
#include <vector>

#include "runtime/remote/foxglove/robot.hpp"

namespace bw::foxglove {

struct GraphDifference {
  /// Whole entries that take the place of older ones; no nodes: nobody any more, while the topic has others
  /// at its other end.
  ConnectionGraph changed;
  std::vector<std::string> removed_topics;  ///< neither published nor subscribed any more
  std::vector<std::string> removed_services;

  bool is_empty() const;
};

GraphDifference difference(const ConnectionGraph& before, const ConnectionGraph& after);

}  // namespace bw::foxglove
