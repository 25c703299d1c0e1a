#include "runtime/host/duplicate_name_guard.hpp"

#include "runtime/host/actor.hpp"

namespace bw {

std::vector<OwnNode> find_own_nodes(const std::vector<Actor*>& local) {
  std::vector<OwnNode> nodes;
  for (const Actor* actor : local) {
    OwnNode node{.name = full_name({.node_namespace = actor->node_namespace, .name = actor->node_name}),
                 .services = {}};
    for (const auto& service : actor->services) node.services.push_back(service->service);
    nodes.push_back(std::move(node));
  }
  return nodes;
}

DomainView DuplicateNameGuard::view(const std::vector<dds::Endpoint>& endpoints) {
  return {.own_participant = participant_.guid(),
          .participants = directory_.participants(),
          .endpoints = endpoints,
          .node_of = [this](const dds::Guid& guid) { return directory_.node_of(guid); }};
}

std::vector<DuplicateNameWatch::News> DuplicateNameGuard::look() {
  const std::lock_guard lock(mutex_);
  const bool has_names = directory_.update();
  const std::uint64_t changes = participant_.endpoint_changes();
  if (!has_names && changes == changes_ && !watch_.is_waiting()) return {};
  changes_ = changes;
  directory_.forget_the_gone();
  const std::vector<dds::Endpoint> endpoints = participant_.endpoints();
  return watch_.look(view(endpoints));
}

std::string DuplicateNameGuard::rivals_of(const std::string& node) {
  const std::lock_guard lock(mutex_);
  directory_.update();
  directory_.forget_the_gone();
  const std::vector<dds::Endpoint> endpoints = participant_.endpoints();
  return watch_.rivals_of(node, view(endpoints));
}

std::map<std::string, DuplicateNameWatch::News> DuplicateNameGuard::states() {
  const std::lock_guard lock(mutex_);
  return watch_.states();
}

}  // namespace bw
