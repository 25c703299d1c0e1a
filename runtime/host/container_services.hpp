// The process as a component container of ROS 2 (composition_interfaces): `ros2 component list` shows what
// runs in it. What runs is said by the graph file alone, which is checked as a whole: loading and unloading
// are refused.
#pragma once

#include <vector>

#include "runtime/component.hpp"
#include "runtime/host/actor.hpp"

namespace bw {

/// Declares ~/_container/list_nodes, load_node and unload_node. `actors` is read when it is asked.
void offer_container_services(Setup& setup, const std::vector<Actor*>& actors);

}  // namespace bw
