#include "components/nav2_servers/adaptor/server_actions.hpp"

#include <utility>

#include "components/messages/nav2_goals.hpp"
#include "components/messages/nav2_layouts.hpp"
#include "components/messages/nav2_results.hpp"

namespace bw {
namespace {

using bandwagon_msgs::msg::PlanRequest;

Duration patience(const Nav2ServersParameters& parameters) {
  return Duration::seconds(parameters.kAcknowledgementTimeout);
}

/// `goal_of` makes a goal of an order.
template <class Action, class Order, class GoalOf>
ServerAction<Order> server_action(Setup& setup, const std::string& name,
                                  const Nav2ServersParameters& parameters, GoalOf goal_of) {
  const auto client = setup.action_client<Action>(name, Need::optional);
  const auto send = [client, goal_of, &parameters](const Order& order, const ServerCallbacks& callbacks) {
    return client.send(
        goal_of(order), patience(parameters),
        {.on_acknowledged = callbacks.on_acknowledged,
         .on_result = [on_end = callbacks.on_end](GoalStatus status, const typename Action::Result* result,
                                                  const Tick& tick) {
           ServerEnd end{.status = status};
           if (result == nullptr) return on_end(end, {}, tick);
           end.error_code = error_code_of(*result);
           end.text = error_text_of(*result);
           if constexpr (requires { result->path(); }) return on_end(end, result->path(), tick);
           on_end(end, {}, tick);
         }});
  };
  return {.is_ready = [client] { return client.is_ready(); },
          .send = send,
          .cancel = [client](const GoalId& id) { client.cancel(id); }};
}

template <class Nav2>
ServerAction<PlanRequest> compute_path(Setup& setup, const Nav2ServersParameters& parameters) {
  using ToPose = typename Nav2::ComputePathToPose;
  using ThroughPoses = typename Nav2::ComputePathThroughPoses;
  const auto to_pose = server_action<ToPose, PlanRequest>(setup, "compute_path_to_pose", parameters,
                                                          [&parameters](const PlanRequest& request) {
                                                            typename ToPose::Goal goal;
                                                            goal.goal(request.goal());
                                                            goal.planner_id(parameters.planner_id);
                                                            return goal;
                                                          });
  const auto through_poses = server_action<ThroughPoses, PlanRequest>(
      setup, "compute_path_through_poses", parameters, [&parameters](const PlanRequest& request) {
        typename ThroughPoses::Goal goal;
        PosesStamped poses = request.via_poses();
        poses.push_back(request.goal());
        set_goal_poses(goal, std::move(poses));
        goal.planner_id(parameters.planner_id);
        return goal;
      });
  // One planner_server has both.
  return {.is_ready = [=] { return to_pose.is_ready() && through_poses.is_ready(); },
          .send =
              [=](const PlanRequest& request, const ServerCallbacks& callbacks) {
                return (request.via_poses().empty() ? to_pose : through_poses).send(request, callbacks);
              },
          .cancel = nullptr};
}

template <class Action>
auto follow_goal(const Nav2ServersParameters& parameters) {
  return [&parameters](const nav_msgs::msg::Path& path) {
    typename Action::Goal goal;
    goal.path(path);
    goal.controller_id(parameters.controller_id);
    goal.goal_checker_id(parameters.goal_checker_id);
    if constexpr (requires { goal.progress_checker_id(parameters.progress_checker_id); })
      goal.progress_checker_id(parameters.progress_checker_id);
    return goal;
  };
}

template <class Action>
typename Action::Goal back_up_goal(const BackUpOrder& order) {
  typename Action::Goal goal;
  goal.target().x(order.distance);
  goal.speed(static_cast<float>(order.speed));
  goal.time_allowance(to_message(order.time));
  return goal;
}

template <class Service>
std::function<void()> clearing(Setup& setup, const std::string& name,
                               const Nav2ServersParameters& parameters) {
  const auto client = setup.client<Service>(name, Need::optional);
  return [client, &parameters] {
    if (client.is_ready())
      client.call({}, patience(parameters), [](const typename Service::Response*, const Tick&) {});
  };
}

}  // namespace

ServerActions declare_server_actions(Setup& setup, const Nav2ServersParameters& parameters) {
  return with_nav2_layout(setup.ros_distro(), [&](auto layout) {
    using Nav2 = decltype(layout);
    using Clear = typename Nav2::ClearEntireCostmap;
    return ServerActions{
        .compute_path = compute_path<Nav2>(setup, parameters),
        .follow_path = server_action<typename Nav2::FollowPath, nav_msgs::msg::Path>(
            setup, "follow_path", parameters, follow_goal<typename Nav2::FollowPath>(parameters)),
        .back_up = server_action<typename Nav2::BackUp, BackUpOrder>(setup, "backup", parameters,
                                                                     back_up_goal<typename Nav2::BackUp>),
        .clear_local_costmap =
            clearing<Clear>(setup, "local_costmap/clear_entirely_local_costmap", parameters),
        .clear_global_costmap =
            clearing<Clear>(setup, "global_costmap/clear_entirely_global_costmap", parameters)};
  });
}

}  // namespace bw
