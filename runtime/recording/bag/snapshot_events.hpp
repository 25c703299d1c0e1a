// The events that a graph's snapshots wait for, found among what its components declare and publish.
#pragma once

#include <vector>

#include "runtime/graph/check_graph.hpp"
#include "runtime/graph/event.hpp"
#include "runtime/graph/snapshot_settings.hpp"

namespace bw::bag {

/// `graph` with the components that are left out, `declarations` of those that are not. What the settings do
/// not name are all events that declared components tell of. An event of a component that is left out never
/// happens. Throws ConfigError with all violations: an unknown event, a topic that nobody publishes, a field
/// that is not there, or nothing at all to wait for.
[[nodiscard]] std::vector<Event> resolve_events(const SnapshotSettings& settings, const Graph& graph,
                                                const std::vector<ComponentDeclaration>& declarations);

}  // namespace bw::bag
