#include "components/navigator/adaptor/navigate_actions.hpp"

#include <cstddef>

#include "components/messages/nav2_layouts.hpp"
#include "components/navigator/adaptor/navigate_messages.hpp"
#include "components/navigator/adaptor/navigation_errors.hpp"

namespace bw {
namespace {

/// More poses than this are not driven through: each renewal of the plan costs a search for each.
constexpr std::size_t kMaxPoses = 1000;

template <class Action>
constexpr NavigateAction action_of() {
  return requires(const typename Action::Goal& goal) { goal.pose(); }
  ? NavigateAction::to_pose : NavigateAction::through_poses;
}

template <class Goal>
PlacedGoal placed(const GoalFrames& frames, const Goal& goal, Time now) {
  if (!goal.behavior_tree().empty())
    return {
        {},
        {GoalFault::behavior_tree, "there are no behavior trees here: behavior_tree must be empty, and is '" +
                                       goal.behavior_tree() + "'"}};
  const auto poses = poses_of(goal);
  if (poses.size() > kMaxPoses)
    return {{},
            {GoalFault::refused, std::to_string(poses.size()) + " poses to drive through are more than " +
                                     std::to_string(kMaxPoses)}};
  if constexpr (requires { goal.pose(); }) return frames.place(goal.pose(), now);
  return frames.place(poses, now);
}

}  // namespace

template <class Action>
void NavigateActions::offer_action(Setup& setup, const std::string& name) {
  using Handle = GoalHandle<Action>;
  const auto result_of = [distro = setup.ros_distro()](const typename Action::Goal& goal,
                                                       const GoalReport& report) {
    typename Action::Result result;
    set_result(result, goal, report, error_code(report, action_of<Action>(), distro));
    return result;
  };
  const auto tell = [this](const Handle& handle, const GoalReport& report, Time now) {
    typename Action::Feedback feedback;
    set_feedback(feedback, handle.goal(), report, make_header(frames_.map_frame(), now));
    handle.feedback(feedback);
  };
  const auto end = [result_of](const Handle& handle, const GoalReport& report) {
    const typename Action::Result result = result_of(handle.goal(), report);
    if (report.status == GoalStatus::succeeded) return handle.succeed(result);
    if (report.status == GoalStatus::canceled) return handle.canceled(result);
    handle.abort(result);
  };
  setup.action<Action>(
      name, {.on_goal =
                 [this, tell, end](const Handle& handle, const Tick& tick) {
                   handle.execute();
                   const std::uint64_t id = desk_.take(placed(frames_, handle.goal(), tick.now), tick);
                   clients_[id] = {
                       .tell = [=](const GoalReport& report, Time now) { tell(handle, report, now); },
                       .end = [=](const GoalReport& report) { end(handle, report); }};
                   desk_.settle(tick);
                 },
             .on_cancel =
                 [this](const Handle& handle, const Tick& tick) {
                   if (handle.is_open()) desk_.cancel(tick);
                   desk_.settle(tick);
                 },
             .abandoned =
                 [result_of](const std::string& reason) {
                   return result_of(
                       {}, {.status = GoalStatus::aborted, .reason = reason, .fault = GoalFault::refused});
                 }});
}

void NavigateActions::offer(Setup& setup) {
  with_nav2_layout(setup.ros_distro(), [&](auto layout) {
    using Nav2 = decltype(layout);
    offer_action<typename Nav2::NavigateToPose>(setup, "navigate_to_pose");
    offer_action<typename Nav2::NavigateThroughPoses>(setup, "navigate_through_poses");
  });
}

void NavigateActions::see(const GoalReport& report, Time now) {
  const auto client = clients_.find(report.goal_id);
  if (client == clients_.end()) return;
  if (!is_final(report.status)) {
    if (report.X_MB) client->second.tell(report, now);
    return;
  }
  client->second.end(report);
  clients_.erase(client);
}

}  // namespace bw
