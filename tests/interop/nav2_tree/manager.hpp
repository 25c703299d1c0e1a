// What Nav2's lifecycle_manager does with the nodes of its list: configures all, activates all in order and
// expects a bond of each within half of the bond's timeout, looks at the bonds five times a second, and takes
// all down when one is lost.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tests/interop/nav2_tree/bond.hpp"
#include "tests/interop/plain/service.hpp"

namespace nav2 {

class Manager {
 public:
  Manager(plain::Node& node, const std::vector<std::string>& node_names);

  /// All to active; the sentence of what went wrong first, or nothing.
  std::optional<std::string> startup();
  /// Beats for a while; the name of a node whose bond is lost.
  std::optional<std::string> watch(std::chrono::milliseconds duration);
  /// Deactivates and cleans up in reverse order, until one is gone.
  void reset();
  /// The same, and the nodes are finalized.
  void shutdown();

 private:
  struct Managed {
    std::string name;
    std::unique_ptr<plain::Client> change_state;
    std::unique_ptr<plain::Client> get_state;
  };
  bool change(Managed& node, std::uint8_t transition);
  void change_down(std::uint8_t transition);
  std::optional<Bytes> call(plain::Client& client, const Bytes& request);
  bool wait_until(std::chrono::milliseconds limit, const std::function<bool()>& seen);

  Bonds bonds_;
  std::vector<Managed> nodes_;
};

}  // namespace nav2
