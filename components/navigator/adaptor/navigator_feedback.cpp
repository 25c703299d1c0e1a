// What the navigator's component does with time: goals of the list that are due, and feedback at a steady
// rate.
#include "components/messages/geometry.hpp"
#include "components/navigator/adaptor/navigator_component.hpp"
#include "components/navigator/adaptor/navigator_messages.hpp"

namespace bw {

void NavigatorComponent::step(const Tick& tick) {
  if (tick.now < stepped_) goals_->shift(stepped_ - tick.now);
  if (tick.now < stepped_) last_feedback_ = {};
  stepped_ = tick.now;
  take_from_list_when_due(tick);
  settle(tick);
  if ((tick.now - last_feedback_).to_seconds() < parameters_.kFeedbackPeriod) return;
  if (navigator_->has_goal()) {
    publish(navigator_->report(situation_.at(tick)), tick);
  } else if (waypoints_.has_list()) {
    tell_of_list(tick);
  }
}

/// Goals of the graph wait until it is known where the robot is. Those of a client do not: it is told soon
/// why they fail.
void NavigatorComponent::take_from_list_when_due(const Tick& tick) {
  if (!goals_->due(tick.now)) return;
  const Situation now = situation_.at(tick);
  if (now.X_MB || waypoints_.has_list()) return take_from_list(now);
  constexpr double kPatience = 10.0;  // [s] until a person is told
  if (told_ || (tick.now - goals_->due_since()).to_seconds() <= kPatience) return;
  log_.warn("the goal waits: no pose from {} yet", situation_.source());
  told_ = true;
}

void NavigatorComponent::publish(const GoalReport& report, const Tick& tick) {
  bandwagon_msgs::msg::NavigationStatus message = to_message(report, header(tick));
  message.number_of_goals_remaining(goals_->see(report, tick.now));
  status_.publish(message);
  actions_.see(report, tick.now);
  if (!is_final(report.status)) tell_of_list(tick);
  last_feedback_ = tick.now;
}

void NavigatorComponent::tell_of_list(const Tick& tick) {
  waypoints_.tell(*goals_);
  last_feedback_ = tick.now;
}

std_msgs::msg::Header NavigatorComponent::header(const Tick& tick) const {
  return make_header(frames_.map_frame(), tick.now);
}

}  // namespace bw
