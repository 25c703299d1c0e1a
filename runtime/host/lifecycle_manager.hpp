// One of this program's two lifecycle managers, as rviz's Nav2 panel looks for them: brings its components up
// and down in the order of the graph, through their own change_state services, whichever process they are in.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <lifecycle_msgs/srv/change_state.hpp>
#include <nav2_msgs/srv/manage_lifecycle_nodes.hpp>

#include "runtime/component.hpp"
#include "runtime/host/actor.hpp"
#include "runtime/host/nested_lifecycle.hpp"
#include "runtime/lifecycle/bring_up.hpp"

namespace bw {

class LifecycleManager final : public Component {
 public:
  struct Node {
    std::string name;
    std::string change_state;  ///< absolute name of its service
    const Actor* actor =
        nullptr;  ///< null: in another process; its state is what the last transition made of it
  };

  /// `nodes` in the order of bring-up; they are active when the run begins.
  explicit LifecycleManager(std::vector<Node> nodes);
  void configure(Setup& setup) override;

 private:
  using Manage = nav2_msgs::srv::ManageLifecycleNodes;

  void begin(std::uint8_t command, const Reply<Manage>& reply);
  void step();
  void end();
  std::vector<lifecycle::State> states() const;

  std::vector<Node> nodes_;
  std::vector<lifecycle::State> known_;
  std::vector<Client<lifecycle_msgs::srv::ChangeState>> clients_;
  std::optional<lifecycle::BringUp> bring_up_;  ///< while a command is under way
  Reply<Manage> reply_;
  Logger log_;
};

}  // namespace bw
