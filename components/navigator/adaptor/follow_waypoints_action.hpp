// Nav2's action follow_waypoints as a front end of the navigator: a list of goals with a stop at each.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "components/navigator/adaptor/goal_desk.hpp"
#include "components/navigator/navigator_parameters.hpp"
#include "runtime/component.hpp"

namespace bw {

class FollowWaypointsAction {
 public:
  /// All of them outlive this.
  FollowWaypointsAction(GoalDesk& desk, const GoalFrames& frames, const NavigatorParameters& parameters)
      : desk_(desk), frames_(frames), parameters_(parameters) {}

  void offer(Setup& setup);
  /// The list in hand is that of a client.
  bool has_list() const { return client_.has_value(); }
  /// Feedback, where it is.
  void tell(const GoalList& list) const;
  /// Ends the client's goal when its list ended.
  void see(const GoalList& list);
  /// A newer goal came while this list was in hand.
  void preempt(const GoalList& list);
  /// The runtime has ended all goals.
  void forget() { client_.reset(); }

 private:
  struct ListClient {
    std::function<void(const GoalList& list)> tell;
    std::function<void(const GoalList& list, GoalList::End end, const std::string& reason)> end;
  };

  template <class Action>
  void offer_action(Setup& setup);
  void end(const GoalList& list, GoalList::End how, const std::string& reason);

  GoalDesk& desk_;
  const GoalFrames& frames_;
  const NavigatorParameters& parameters_;
  std::optional<ListClient> client_;
};

}  // namespace bw
