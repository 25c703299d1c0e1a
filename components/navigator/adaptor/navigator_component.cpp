#include "components/navigator/adaptor/navigator_component.hpp"

#include <utility>

#include <std_msgs/msg/empty.hpp>

#include "components/messages/geometry.hpp"
#include "components/navigator/adaptor/navigator_messages.hpp"

namespace bw {

using namespace bandwagon_msgs::msg;

void NavigatorComponent::configure(Setup& setup) {
  parameters_ = setup.parameters<NavigatorParameters>(
      [this](const NavigatorParameters& changed, const Tick&) {
        parameters_ = changed;
        navigator_->set_options(changed);
      },
      {"goal", "goals", "waypoint_pause", "number_of_loops", "stop_on_failure", "pose_source", "follow_waypoints"});
  navigator_.emplace(parameters_);
  goals_.emplace(parameters_.goal_list());
  log_ = setup.log();
  const auto transforms = setup.transforms();
  frames_.listen(setup, transforms);
  situation_.listen(setup, parameters_, transforms);
  plan_request_ = setup.output<PlanRequest>("plan_request");
  follow_request_ = setup.output<FollowRequest>("follow_request");
  status_ = setup.output<NavigationStatus>("navigation_status", Qos::latched());
  listen(setup);
  actions_.offer(setup);
  if (parameters_.follow_waypoints) waypoints_.offer(setup);
  setup.every(Duration::seconds(1.0 / parameters_.rate), "step", [this](const Tick& tick) { step(tick); });
}

void NavigatorComponent::listen(Setup& setup) {
  setup.input<geometry_msgs::msg::PoseStamped>(
      "goal_pose", Qos::standard(),
      [this](const auto& goal, const Tick& tick) {
        take(frames_.place(goal, tick.now), tick);
        settle(tick);
      },
      Need::optional);
  setup.input<std_msgs::msg::Empty>(
      "cancel_goal", Qos::standard(),
      [this](const auto&, const Tick& tick) {
        cancel(tick);
        settle(tick);
      },
      Need::optional);
  setup.input<PlanResult>("plan_result", Qos::standard(), [this](const auto& result, const Tick& tick) {
    navigator_->on_plan(from_message(result), situation_.at(tick));
    settle(tick);
  });
  setup.input<FollowStatus>("follow_status", Qos::standard(), [this](const auto& status, const Tick& tick) {
    navigator_->on_follow(from_message(status), situation_.at(tick));
    settle(tick);
  });
}

void NavigatorComponent::activate(const Tick& tick) { goals_->activate(tick.now); }

void NavigatorComponent::deactivate(const Tick& tick) {
  actions_.forget();
  waypoints_.forget();
  cancel(tick);
  settle(tick);
}

std::uint64_t NavigatorComponent::take(const PlacedGoal& placed, const Tick& tick) {
  const GoalProblem problem = placed.is_good() ? hindrance(tick) : placed.problem;
  if (problem.fault != GoalFault::none) return navigator_->refuse(placed.goal.X_MG, problem);
  drop_list();
  return navigator_->accept(placed.goal, situation_.at(tick));
}

GoalProblem NavigatorComponent::hindrance(const Tick& tick) const {
  return navigator_->hindrance(situation_.at(tick));
}

void NavigatorComponent::take_list(GoalListOptions options, const Tick& tick) {
  drop_list();
  goals_.emplace(std::move(options));
  goals_->activate(tick.now);
  take_from_list(situation_.at(tick));
}

void NavigatorComponent::drop_list() {
  waypoints_.preempt(*goals_);
  goals_->give_up("preempted by a newer goal");
}

void NavigatorComponent::take_from_list(const Situation& now) {
  if (const auto X_MG = goals_->due(now.now)) goals_->taken(navigator_->accept({*X_MG, {}}, now));
}

void NavigatorComponent::cancel(const Tick& tick) {
  goals_->give_up("canceled by request");
  navigator_->cancel(situation_.at(tick));
}

void NavigatorComponent::settle(const Tick& tick) {
  const NavigatorActions actions = navigator_->step(situation_.at(tick));
  for (const GoalReport& report : actions.reports) {
    log(report, log_);
    publish(report, tick);
  }
  waypoints_.see(*goals_);
  if (actions.follow) follow_request_.publish(to_message(*actions.follow, header(tick)));
  if (actions.plan) plan_request_.publish(to_message(*actions.plan, header(tick)));
}

BW_COMPONENT(NavigatorComponent, "navigator")

}  // namespace bw
