// A component whose behaviour is a lambda, for tests of the host.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "runtime/component.hpp"
#include "runtime/graph/graph.hpp"

namespace bw {

class Scripted final : public Component {
 public:
  explicit Scripted(std::function<void(Setup&)> script) : script_(std::move(script)) {}
  void configure(Setup& setup) override { script_(setup); }

 private:
  std::function<void(Setup&)> script_;
};

/// `node` with a type of its own that `script` configures.
inline ComponentNode scripted(ComponentNode node, std::function<void(Setup&)> script) {
  static int counter = 0;
  node.type = "scripted" + std::to_string(counter++);
  register_component(node.type, [script] { return std::make_unique<Scripted>(script); });
  return node;
}

}  // namespace bw
