#include "runtime/remote/foxglove/graph_difference.hpp"

namespace bw::foxglove {
namespace {

using NodesOf = std::map<std::string, std::set<std::string>>;

NodesOf changed_entries(const NodesOf& before, const NodesOf& after) {
  NodesOf changed;
  for (const auto& [name, nodes] : after) {
    const auto old = before.find(name);
    if (old == before.end() || old->second != nodes) changed[name] = nodes;
  }
  return changed;
}

}  // namespace

bool GraphDifference::is_empty() const {
  return changed.published.empty() && changed.subscribed.empty() && changed.services.empty() &&
         removed_topics.empty() && removed_services.empty();
}

GraphDifference difference(const ConnectionGraph& before, const ConnectionGraph& after) {
  GraphDifference found;
  found.changed = {changed_entries(before.published, after.published),
                   changed_entries(before.subscribed, after.subscribed),
                   changed_entries(before.services, after.services)};
  std::set<std::string> removed;
  const auto look = [&removed](const NodesOf& old, const NodesOf& now, const NodesOf& other_end,
                               NodesOf& changed) {
    for (const auto& [topic, nodes] : old) {
      if (now.contains(topic)) continue;
      if (other_end.contains(topic))
        changed[topic] = {};
      else
        removed.insert(topic);
    }
  };
  look(before.published, after.published, after.subscribed, found.changed.published);
  look(before.subscribed, after.subscribed, after.published, found.changed.subscribed);
  found.removed_topics.assign(removed.begin(), removed.end());
  for (const auto& [service, nodes] : before.services) {
    if (!after.services.contains(service)) found.removed_services.push_back(service);
  }
  return found;
}

}  // namespace bw::foxglove
