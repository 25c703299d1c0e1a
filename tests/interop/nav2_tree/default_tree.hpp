// Nav2's default tree, navigate_to_pose_w_replanning_and_recovery of Jazzy: a new path each second, six
// recoveries in turn, of which only some errors are worth one. The selectors of planner and controller keep
// their defaults, and GoalUpdated is left out: there is one goal.
#pragma once

#include <string>

#include "tests/interop/nav2_tree/service_leaf.hpp"

namespace nav2 {

struct Blackboard {
  PoseStamped goal;
  Path path;
  int compute_path_error_code = 0;
  int follow_path_error_code = 0;
  int number_recoveries = 0;
  std::string selected_controller = "FollowPath";
  std::string selected_planner = "GridBased";
};

class DefaultTree {
 public:
  DefaultTree(plain::Node& node, Journal& journal, Blackboard& board);

  /// Waits a second for each server, as the nodes do when they are made; the name of one that is not there.
  std::optional<std::string> missing_server();
  Status tick() { return root_->tick(); }
  void halt() { root_->halt(); }
  /// Takes what comes between two ticks.
  void poll();

 private:
  NodePtr action(PostedTask errand);
  NodePtr compute_path();
  NodePtr follow_path();
  NodePtr behavior(const std::string& action, const std::string& type, const Bytes& goal);
  NodePtr clear(const std::string& costmap);
  NodePtr planner_recovery_helps();
  NodePtr controller_recovery_helps();
  NodePtr navigate_with_replanning();
  NodePtr recover();

  plain::Node& node_;
  Journal& journal_;
  Blackboard& board_;
  std::vector<ActionLeaf*> actions_;     ///< of the tree
  std::vector<ClearCostmap*> services_;  ///< of the tree
  NodePtr root_;
};

}  // namespace nav2
