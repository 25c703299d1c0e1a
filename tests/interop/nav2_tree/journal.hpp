// What happened between the tree and the servers, with times, for whoever judges the drive.
#pragma once

#include <string>
#include <vector>

#include "tests/interop/nav2_tree/tree_nodes.hpp"

namespace nav2 {

/// A request that a server has to answer within 20 ms.
struct Exchange {
  std::string what;    ///< follow_path, follow_path cancel, local_costmap/clear_entirely_local_costmap
  double at = 0.0;     ///< [s] since the start of the drive
  double took = -1.0;  ///< [s] until the answer was there; below 0: none came before the tree gave up
  bool accepted = false;
};

/// The end of a goal. Those that were replaced by a new one end as well.
struct GoalEnd {
  std::string action;
  double at = 0.0;
  int status = 0;  ///< action_msgs/GoalStatus
  int code = 0;
  std::string text;
  bool was_replaced = false;
};

struct Journal {
  Clock::time_point start = Clock::now();
  std::vector<Exchange> exchanges;
  std::vector<GoalEnd> ends;
  std::vector<double> preemptions;  ///< [s] instants at which follow_path got a new path while it drove
  std::vector<std::string> troubles;

  double now() const { return since(Clock::now()); }
  double since(Clock::time_point then) const { return std::chrono::duration<double>(then - start).count(); }
};

}  // namespace nav2
