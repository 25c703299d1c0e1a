// Nav2's actions navigate_to_pose and navigate_through_poses as front ends of the navigator. A goal that
// comes preempts what is in hand, whoever set it; results carry Nav2's error codes and the navigator's
// sentence.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "components/navigator/adaptor/goal_desk.hpp"
#include "runtime/component.hpp"

namespace bw {

class NavigateActions {
 public:
  /// The desk and the frames outlive this.
  NavigateActions(GoalDesk& desk, const GoalFrames& frames) : desk_(desk), frames_(frames) {}

  void offer(Setup& setup);
  /// A report of the navigator: feedback, or the end, for the client whose goal it is.
  void see(const GoalReport& report, Time now);
  /// The runtime has ended all goals.
  void forget() { clients_.clear(); }

 private:
  struct GoalClient {
    std::function<void(const GoalReport& report, Time now)> tell;  ///< the report has a pose
    std::function<void(const GoalReport& report)> end;
  };

  template <class Action>
  void offer_action(Setup& setup, const std::string& name);

  GoalDesk& desk_;
  const GoalFrames& frames_;
  std::map<std::uint64_t, GoalClient> clients_;  ///< by the navigator's id
};

}  // namespace bw
