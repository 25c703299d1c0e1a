#include "components/navigator/adaptor/navigator_component.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <std_msgs/msg/empty.hpp>

#include "components/messages/geometry.hpp"
#include "components/messages/planning_inputs.hpp"
#include "components/navigator/adaptor/navigator_messages.hpp"

namespace bw {

using namespace bandwagon_msgs::msg;

namespace {

std::string to_text(const Pose2& pose) { return fmt::format("{} {} {}\n", pose.x, pose.y, pose.theta); }

std::optional<Pose2> pose_from_text(const std::string& text) {
  std::istringstream in(text);
  Pose2 pose;
  in >> pose.x >> pose.y >> pose.theta;
  return in && is_finite(pose) ? std::optional(pose) : std::nullopt;
}

}  // namespace

void NavigatorComponent::configure(Setup& setup) {
  parameters_ = setup.parameters<NavigatorParameters>(
      [this](const NavigatorParameters& changed, const Tick&) {
        parameters_ = changed;
        navigator_->set_options(changed);
      },
      {"goal", "goals", "waypoint_pause", "number_of_loops", "stop_on_failure", "pose_source",
       "follow_waypoints"});
  navigator_.emplace(parameters_);
  log_ = setup.log();
  keepsake_ = setup.keepsake("goal");
  goals_.emplace(first_goals());
  const auto transforms = setup.transforms();
  frames_.listen(setup, transforms);
  situation_.listen(setup, parameters_, transforms);
  lost_ = setup.failsafe(
      {.name = "pose_lost",
       .condition = "no pose while a goal is in hand",
       .debounce = PlanningInputs::kTransformTolerance,
       .recovery = fmt::format("by itself with the next pose, within {:g} s; then the goal is aborted",
                               parameters_.lost_patience)});
  plan_request_ = setup.output<PlanRequest>("plan_request");
  follow_request_ = setup.output<FollowRequest>("follow_request");
  status_ = setup.output<NavigationStatus>("navigation_status", Qos::latched());
  listen(setup);
  actions_.offer(setup);
  if (parameters_.follow_waypoints) waypoints_.offer(setup);
  setup.every(Duration::seconds(1.0 / parameters_.rate), "step", [this](const Tick& tick) { step(tick); });
}

/// Those of the graph; where a goal was in hand when the process before this one was killed, from that one on. Like them
/// it waits for a pose.
GoalListOptions NavigatorComponent::first_goals() const {
  GoalListOptions list = parameters_.goal_list();
  const std::optional<Pose2> left = pose_from_text(keepsake_.left());
  if (!left) return list;
  log_.warn("the goal of the process before this one, ({:.2f}, {:.2f}, {:.2f}), is taken up again", left->x,
            left->y, left->theta);
  const auto same = std::ranges::find(list.goals, *left);
  if (same == list.goals.end()) return {.goals = {*left}};
  list.first = static_cast<std::size_t>(same - list.goals.begin());
  list.delay = 0.0;
  return list;
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
  keepsake_.keep("");
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
  keep(tick);
  lost_.set(navigator_->has_goal() && !situation_.at(tick).X_MB);
  if (actions.follow) follow_request_.publish(to_message(*actions.follow, header(tick)));
  if (actions.plan) plan_request_.publish(to_message(*actions.plan, header(tick)));
}

void NavigatorComponent::keep(const Tick& tick) {
  const std::uint64_t in_hand = navigator_->has_goal() ? navigator_->goal_id() : 0;
  if (std::exchange(kept_, in_hand) == in_hand) return;
  keepsake_.keep(in_hand == 0 ? "" : to_text(navigator_->report(situation_.at(tick)).X_MG));
}

BW_COMPONENT(NavigatorComponent, "navigator")

}  // namespace bw
