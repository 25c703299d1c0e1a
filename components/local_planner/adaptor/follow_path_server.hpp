// The action follow_path of Nav2's controller_server, in the layout of the graph's ros_distro: goals are
// read, told apart and answered here; what they ask for is driven by whoever owns this.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <nav_msgs/msg/path.hpp>

#include "components/local_planner/follow_path/follow_judge.hpp"
#include "components/local_planner/follow_path/plugin_choice.hpp"
#include "components/local_planner/follow_path/received_path.hpp"
#include "components/messages/nav2_results.hpp"
#include "runtime/component.hpp"

namespace bw {

class FollowPathServer {
 public:
  struct Uses {
    /// Why poses of this frame are of no use; empty: they can be followed.
    std::function<std::string(const std::string& frame)> fault_of_frame;
    /// Follow it from now on. `poses` are those of the path in use.
    std::function<void(const std::string& frame, const std::vector<Pose2>& poses)> drive;
    /// The goal in hand is over: command a standstill.
    std::function<void(const Tick& tick)> stop;
  };
  /// A goal of any layout.
  struct Goal {
    GoalId id{};
    std::function<void(const PathTracking&)> feedback;
    std::function<void()> succeed;
    std::function<void()> cancel;
    std::function<void(const FollowFailure&)> abort;
  };

  void offer(Setup& setup, const FollowPathOptions& options, Uses uses);
  void set_options(const FollowPathOptions& options) { options_ = options; }

  bool is_driving() const { return goal_.has_value(); }
  GoalTolerance tolerance() const { return options_.goal_checker.tolerance(); }
  /// In every cycle while it drives. False when that was the last: then it has stopped.
  bool goes_on(const FollowCycle& cycle, const Tick& tick);
  /// `tracking.path_index` is that of the path in use.
  void tell(PathTracking tracking) const;
  /// Somebody else says where to go: the goal in hand ends aborted, and nothing is stopped.
  void give_way(const std::string& to_whom);
  /// The runtime has ended what was open.
  void forget() { goal_.reset(); }

  // Called for goals of the action.
  void take(Goal goal, const PluginIds& ids, const nav_msgs::msg::Path& path, const Tick& tick);
  void cancel(const GoalId& id, const Tick& tick);

 private:
  FollowPathOptions options_;
  Uses uses_;
  Logger log_;
  std::optional<Goal> goal_;  ///< in hand
  ReceivedPath path_;
  FollowJudge judge_;
};

}  // namespace bw
