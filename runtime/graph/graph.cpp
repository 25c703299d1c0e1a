#include "runtime/graph/graph.hpp"

#include <algorithm>

namespace bw {

std::string ComponentNode::topic_of(std::string_view declared) const {
  return resolve_name(node_namespace, name, declared, remaps);
}

const InputSettings* ComponentNode::input(std::string_view declared) const {
  const auto found = std::find_if(inputs.begin(), inputs.end(), [&](const InputSettings& input) {
    return input.name == without_action_part(declared);
  });
  return found == inputs.end() ? nullptr : &*found;
}

const ComponentNode* Graph::find(std::string_view component) const {
  const auto found = std::find_if(components.begin(), components.end(),
                                  [&](const ComponentNode& node) { return node.name == component; });
  return found == components.end() ? nullptr : &*found;
}

std::vector<std::string> Graph::processes() const {
  std::vector<std::string> names;
  for (const ComponentNode& node : components) {
    if (std::find(names.begin(), names.end(), node.process) == names.end()) names.push_back(node.process);
  }
  return names;
}

std::vector<const ComponentNode*> Graph::bring_up_order() const {
  std::vector<const ComponentNode*> order;
  for (const std::string& name : bring_up) {
    if (const ComponentNode* node = find(name)) order.push_back(node);
  }
  for (const ComponentNode& node : components) {
    if (std::find(order.begin(), order.end(), &node) == order.end()) order.push_back(&node);
  }
  return order;
}

}  // namespace bw
