#include "components/navigator/adaptor/follow_waypoints_action.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

#include "components/messages/nav2_layouts.hpp"
#include "components/model/nav2_error_codes.hpp"
#include "components/navigator/adaptor/navigate_messages.hpp"
#include "components/navigator/adaptor/navigation_errors.hpp"

namespace bw {
namespace {

template <class Goal>
PlacedGoal placed_waypoints(const GoalFrames& frames, const Goal& goal, Time now) {
  PlacedGoal all = frames.place(goal_poses(goal), now);
  const std::size_t first = first_waypoint(goal), count = goal_poses(goal).size();
  if (all.is_good() && first >= count)
    all.problem = {GoalFault::no_poses,
                   "goal_index " + std::to_string(first) + " is none of " + std::to_string(count) + " poses"};
  return all;
}

template <class Result>
void add_missed(Result& result, const GoalList& list, const std::string& map_frame, RosDistro distro) {
  for (const MissedGoal& missed : list.missed())
    add_missed_waypoint(result, static_cast<std::uint32_t>(missed.index),
                        in_map(list.goals()[missed.index], make_header(map_frame, {})),
                        error_code(missed.report, NavigateAction::to_pose, distro), missed.report.reason);
}

template <class Result>
Result failure(std::uint16_t code, const std::string& reason) {
  Result result;
  set_error(result, code, reason);
  return result;
}

}  // namespace

template <class Action>
void FollowWaypointsAction::offer_action(Setup& setup) {
  using Handle = GoalHandle<Action>;
  using Result = typename Action::Result;
  const RosDistro distro = setup.ros_distro();
  const auto tell = [](const Handle& handle, const GoalList& list) {
    typename Action::Feedback feedback;
    feedback.current_waypoint(static_cast<std::uint32_t>(list.current()));
    handle.feedback(feedback);
  };
  const auto end = [this, distro](const Handle& handle, const GoalList& list, GoalList::End how,
                                  const std::string& reason) {
    auto result =
        failure<Result>(how == GoalList::End::stopped ? stopped_list_code(distro) : std::uint16_t{0}, reason);
    add_missed(result, list, frames_.map_frame(), distro);
    if (how == GoalList::End::completed) return handle.succeed(result);
    if (how == GoalList::End::given_up) return handle.canceled(result);
    handle.abort(result);
  };
  const auto on_goal = [this, tell, end, distro](const Handle& handle, const Tick& tick) {
    handle.execute();
    PlacedGoal all = placed_waypoints(frames_, handle.goal(), tick.now);
    if (all.is_good()) all.problem = desk_.hindrance(tick);
    if (!all.is_good()) {
      desk_.take(all, tick);
      desk_.settle(tick);
      return handle.abort(failure<Result>(no_waypoints_code(distro), all.problem.reason));
    }
    all.goal.via.push_back(all.goal.X_MG);
    desk_.take_list({.goals = std::move(all.goal.via),
                     .pause = parameters_.waypoint_pause,
                     .loops = number_of_loops(handle.goal()),
                     .stop_on_failure = parameters_.stop_on_failure,
                     .first = first_waypoint(handle.goal())},
                    tick);
    client_ = {.tell = [=](const GoalList& list) { tell(handle, list); },
               .end = [=](const GoalList& list, GoalList::End how,
                          const std::string& reason) { end(handle, list, how, reason); }};
    desk_.settle(tick);
  };
  setup.action<Action>("follow_waypoints", {.on_goal = on_goal,
                                            .on_cancel =
                                                [this](const Handle& handle, const Tick& tick) {
                                                  if (handle.is_open()) desk_.cancel(tick);
                                                  desk_.settle(tick);
                                                },
                                            .abandoned =
                                                [](const std::string& reason) {
                                                  return failure<Result>(follow_waypoints_error::kUnknown,
                                                                         reason);
                                                }});
}

void FollowWaypointsAction::offer(Setup& setup) {
  with_nav2_layout(setup.ros_distro(),
                   [&](auto layout) { offer_action<typename decltype(layout)::FollowWaypoints>(setup); });
}

void FollowWaypointsAction::tell(const GoalList& list) const {
  if (client_) client_->tell(list);
}

void FollowWaypointsAction::see(const GoalList& list) {
  if (client_ && list.end() != GoalList::End::none) end(list, list.end(), list.end_reason());
}

void FollowWaypointsAction::preempt(const GoalList& list) {
  if (client_) end(list, GoalList::End::none, "preempted by a newer goal");
}

void FollowWaypointsAction::end(const GoalList& list, GoalList::End how, const std::string& reason) {
  std::exchange(client_, std::nullopt)->end(list, how, reason);
}

}  // namespace bw
