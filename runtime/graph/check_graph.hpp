// What must hold between components before anything starts: every end of a topic agrees with the others, and
// nothing is left open.
#pragma once

#include <string>
#include <vector>

#include "runtime/graph/graph.hpp"
#include "runtime/graph/qos.hpp"

namespace bw {

struct InputDeclaration {
  std::string name;  ///< as written in the component; the graph makes it a topic
  std::string type;  ///< nav_msgs/msg/Odometry
  Qos qos;
  bool optional = false;     ///< the component works without
  bool only_newest = false;  ///< it is looked at and calls nothing
};

struct OutputDeclaration {
  std::string name;
  std::string type;
  Qos qos;
  bool command = false;  ///< it moves something: no second publisher may exist
};

struct ServiceDeclaration {
  std::string name;
  std::string type;  ///< std_srvs/srv/Trigger
};

struct ClientDeclaration {
  std::string name;
  std::string type;
  bool optional = false;  ///< the component works without a server
};

/// The ends that a configured component has declared.
struct ComponentDeclaration {
  std::string name;  ///< of the instance in the graph
  std::vector<InputDeclaration> inputs;
  std::vector<OutputDeclaration> outputs;
  std::vector<ServiceDeclaration> services = {};
  std::vector<ClientDeclaration> clients = {};
};

/// All violations, in the order of the declarations; empty: the graph may start. Located at the component,
/// remap or input concerned.
std::vector<Violation> check_graph(const std::vector<ComponentDeclaration>& declarations, const Graph& graph);

}  // namespace bw
