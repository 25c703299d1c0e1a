#include "components/local_planner/adaptor/follow_path_server.hpp"

#include <utility>

#include "components/messages/geometry.hpp"
#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_layouts.hpp"

namespace bw {
namespace {

template <class A>
typename A::Result to_result(const FollowFailure& failure) {
  typename A::Result result;
  set_error(result, static_cast<Nav2ErrorCode>(failure.fault), failure.reason);
  return result;
}

template <class A>
FollowPathServer::Goal to_goal(const GoalHandle<A>& handle) {
  return {.id = handle.id(),
          .feedback =
              [handle](const PathTracking& tracking) {
                typename A::Feedback feedback;
                set_tracking(feedback, tracking);
                handle.feedback(feedback);
              },
          .succeed = [handle] { handle.succeed({}); },
          .cancel =
              [handle] {
                handle.canceled(to_result<A>({FollowFault::none, "canceled"}));
              },
          .abort = [handle](const FollowFailure& failure) { handle.abort(to_result<A>(failure)); }};
}

template <class Goal>
PluginIds ids_of(const Goal& goal) {
  PluginIds ids{goal.controller_id(), goal.goal_checker_id(), progress_checker_id(goal), {}};
  if constexpr (requires { goal.path_handler_id(); }) ids.path_handler = goal.path_handler_id();
  return ids;
}

template <class A>
void offer_as(Setup& setup, FollowPathServer& server) {
  setup.action<A>("follow_path",
                  {.on_goal =
                       [&server](const GoalHandle<A>& handle, const Tick& tick) {
                         handle.execute();
                         server.take(to_goal(handle), ids_of(handle.goal()), handle.goal().path(), tick);
                       },
                   .on_cancel = [&server](const GoalHandle<A>& handle,
                                          const Tick& tick) { server.cancel(handle.id(), tick); },
                   .abandoned =
                       [](const std::string& reason) {
                         return to_result<A>({FollowFault::unknown, reason});
                       }});
}

}  // namespace

void FollowPathServer::offer(Setup& setup, const FollowPathOptions& options, Uses uses) {
  options_ = options;
  uses_ = std::move(uses);
  log_ = setup.log();
  with_nav2_layout(setup.ros_distro(),
                   [&](auto layout) { offer_as<typename decltype(layout)::FollowPath>(setup, *this); });
}

// What cannot be followed preempts as well: its client has the new goal in hand and no way to cancel the one
// before, which would drive on with nobody above it.
void FollowPathServer::take(Goal goal, const PluginIds& ids, const nav_msgs::msg::Path& path,
                            const Tick& tick) {
  const std::string& frame = path.header().frame_id();
  FollowFailure failure = unknown_plugin(ids, options_);
  ReceivedPath received;
  if (failure.fault == FollowFault::none) {
    received = received_path(from_path(path));
    if (!received.fault.empty()) failure = {FollowFault::invalid_path, received.fault};
  }
  if (failure.fault == FollowFault::none) {
    const std::string fault = uses_.fault_of_frame(frame);
    if (!fault.empty()) failure = {FollowFault::tf_error, fault};
  }
  if (failure.fault != FollowFault::none) {
    log_.warn("a goal of follow_path is not taken: {}", failure.reason);
    if (goal_) {
      give_way("preempted by a goal that cannot be followed");
      uses_.stop(tick);
    }
    return goal.abort(failure);
  }
  if (goal_) {
    goal_->abort({FollowFault::unknown, "preempted by a newer path"});
  } else {
    judge_.begin();
  }
  goal_ = std::move(goal);
  path_ = std::move(received);
  uses_.drive(frame, path_.poses);
}

void FollowPathServer::cancel(const GoalId& id, const Tick& tick) {
  if (!goal_ || goal_->id != id) return;
  const Goal goal = *std::exchange(goal_, std::nullopt);
  uses_.stop(tick);
  goal.cancel();
}

bool FollowPathServer::goes_on(const FollowCycle& cycle, const Tick& tick) {
  const FollowVerdict verdict = judge_.judge(cycle, options_);
  if (!verdict.is_over) return true;
  const Goal goal = *std::exchange(goal_, std::nullopt);
  uses_.stop(tick);
  if (verdict.failure.fault == FollowFault::none) {
    goal.succeed();
  } else {
    log_.warn("follow_path: {}", verdict.failure.reason);
    goal.abort(verdict.failure);
  }
  return false;
}

void FollowPathServer::tell(PathTracking tracking) const {
  tracking.path_index = static_cast<std::uint32_t>(path_.index[tracking.path_index]);
  goal_->feedback(tracking);
}

void FollowPathServer::give_way(const std::string& to_whom) {
  if (!goal_) return;
  std::exchange(goal_, std::nullopt)->abort({FollowFault::unknown, to_whom});
}

}  // namespace bw
