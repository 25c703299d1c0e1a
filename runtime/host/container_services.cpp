#include "runtime/host/container_services.hpp"

#include <composition_interfaces/srv/list_nodes.hpp>
#include <composition_interfaces/srv/load_node.hpp>
#include <composition_interfaces/srv/unload_node.hpp>

#include "runtime/graph/names.hpp"

namespace bw {

using composition_interfaces::srv::ListNodes;
using composition_interfaces::srv::LoadNode;
using composition_interfaces::srv::UnloadNode;

void offer_container_services(Setup& setup, const std::vector<Actor*>& actors) {
  setup.service<ListNodes>("~/_container/list_nodes", [&actors](const ListNodes::Request&, const Tick&) {
    ListNodes::Response response;
    for (const Actor* actor : actors) {
      if (actor->role != ActorRole::component) continue;
      response.full_node_names().push_back(resolve_name(actor->node_namespace, actor->node_name, "~"));
      response.unique_ids().push_back(actor->rank);
    }
    return response;
  });
  setup.service<LoadNode>("~/_container/load_node", [](const LoadNode::Request&, const Tick&) {
    LoadNode::Response response;
    response.success(false);
    response.error_message(
        "the graph file says what runs in this process: name the component there and start the graph anew");
    return response;
  });
  setup.service<UnloadNode>("~/_container/unload_node", [](const UnloadNode::Request&, const Tick&) {
    UnloadNode::Response response;
    response.success(false);
    response.error_message(
        "components of a graph stay in it: deactivate or clean up this one through its lifecycle");
    return response;
  });
}

}  // namespace bw
