// A planner_server and a controller_server of somebody else: straight paths, followed by pure pursuit
// (Coulter 1992) without a look at what is in the way, to the last of several poses. They behave towards a
// navigator as Nav2's: a new goal of follow_path takes over at once and the old one ends aborted, zero is
// commanded at the end.
#pragma once

#include <optional>

#include "tests/interop/nav2_tree/frames.hpp"
#include "tests/interop/plain/action_server.hpp"

namespace nav2 {

class ForeignPlanner {
 public:
  ForeignPlanner(plain::Node& node, Frames& frames);
  void poll();
  int plans() const { return plans_; }

 private:
  void answer(plain::ActionServer& server, std::size_t& seen, Pose (*last_of)(CdrIn&));

  Frames& frames_;
  plain::ActionServer to_pose_, through_poses_;
  plain::Server clear_;
  std::size_t seen_to_pose_ = 0, seen_through_poses_ = 0;
  int plans_ = 0;
};

class ForeignController {
 public:
  ForeignController(plain::Node& node, Frames& frames, const std::string& topic);
  /// Answers requests; to be called often.
  void poll();
  /// A cycle of control, 20 times a second.
  void control();
  int preemptions() const { return preemptions_; }

 private:
  void command(double speed, double angular);
  void finish(plain::GoalStatus status);

  Frames& frames_;
  plain::ActionServer server_;
  plain::Server clear_;
  plain::dds::DataWriter* out_;
  std::size_t seen_ = 0;
  std::optional<plain::GoalId> goal_;
  Path path_;
  int preemptions_ = 0;
};

}  // namespace nav2
