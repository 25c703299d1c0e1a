// A leaf that calls a service, with the timing of nav2_behavior_tree's service node: it fails without an
// answer in 20 ms.
#pragma once

#include "tests/interop/nav2_tree/action_leaf.hpp"

namespace nav2 {

/// nav2_msgs/srv/ClearEntireCostmap, up to Kilted: std_msgs/Empty both ways.
class ClearCostmap final : public TreeNode {
 public:
  ClearCostmap(plain::Node& node, Journal& journal, std::string service, std::function<void()> on_call)
      : journal_(journal),
        service_(std::move(service)),
        on_call_(std::move(on_call)),
        client_(node, "/" + service_, {"nav2_msgs/srv/ClearEntireCostmap", "", ""}) {}

  plain::Client& client() { return client_; }
  const std::string& service() const { return service_; }

 private:
  Status on_tick() override;
  void on_halt() override { asked_.reset(); }

  Journal& journal_;
  std::string service_;
  std::function<void()> on_call_;
  plain::Client client_;
  std::optional<std::int64_t> asked_;
  Clock::time_point at_;
};

}  // namespace nav2
