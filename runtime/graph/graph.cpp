#include "runtime/graph/graph.hpp"

#include <algorithm>

namespace bw {

std::string ComponentNode::topic_of(std::string_view declared) const {
  return resolve_name(node_namespace, node_name(), declared, remaps);
}

std::string ComponentNode::node_name() const {
  return node.empty() ? name.substr(name.rfind('/') + 1) : node;
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
  const auto add = [&](const ComponentNode& node) {
    if (!node.follows.empty() || std::find(order.begin(), order.end(), &node) != order.end()) return;
    const std::vector<const ComponentNode*> led = followers_of(node.name);
    order.insert(order.end(), led.begin(), led.end());
    order.push_back(&node);
  };
  for (const std::string& name : bring_up) {
    if (const ComponentNode* node = find(name)) add(*node);
  }
  for (const ComponentNode& node : components) add(node);
  return order;
}

std::vector<const ComponentNode*> Graph::followers_of(std::string_view leader) const {
  std::vector<const ComponentNode*> led;
  for (const ComponentNode& node : components) {
    if (node.follows == leader && node.enabled) led.push_back(&node);
  }
  return led;
}

}  // namespace bw
