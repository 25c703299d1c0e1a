// Adaptor of the navigator: goals from /goal_pose, the graph and actions, requests to the planners, status
// for everybody.
#pragma once

#include <cstdint>
#include <optional>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/navigation_status.hpp>
#include <bandwagon_msgs/msg/plan_request.hpp>

#include "components/navigator/adaptor/follow_waypoints_action.hpp"
#include "components/navigator/adaptor/goal_desk.hpp"
#include "components/navigator/adaptor/navigate_actions.hpp"
#include "components/navigator/adaptor/robot_situation.hpp"
#include "components/navigator/navigator.hpp"
#include "runtime/component.hpp"

namespace bw {

class NavigatorComponent final : public Component, private GoalDesk {
 public:
  void configure(Setup& setup) override;
  void activate(const Tick& tick) override;
  void deactivate(const Tick& tick) override;

 private:
  void listen(Setup& setup);

  // Goals in hand.
  std::uint64_t take(const PlacedGoal& placed, const Tick& tick) override;
  GoalProblem hindrance(const Tick& tick) const override;
  void take_list(GoalListOptions options, const Tick& tick) override;
  void cancel(const Tick& tick) override;
  void settle(const Tick& tick) override;
  void drop_list();
  void take_from_list(const Situation& now);
  GoalListOptions first_goals() const;
  void keep(const Tick& tick);

  // What goes on with time.
  void step(const Tick& tick);
  void take_from_list_when_due(const Tick& tick);
  void publish(const GoalReport& report, const Tick& tick);
  void tell_of_list(const Tick& tick);
  std_msgs::msg::Header header(const Tick& tick) const;

  NavigatorParameters parameters_;
  std::optional<Navigator> navigator_;
  std::optional<GoalList> goals_;
  Time last_feedback_;
  Time stepped_;
  Failsafe lost_;
  Keepsake keepsake_;
  std::uint64_t kept_ = 0;  ///< the goal that it has; 0: none
  bool told_ = false;       ///< a person, that goals wait for a pose
  Logger log_;
  GoalFrames frames_;
  RobotSituation situation_;
  NavigateActions actions_{*this, frames_};
  FollowWaypointsAction waypoints_{*this, frames_, parameters_};
  Output<bandwagon_msgs::msg::PlanRequest> plan_request_;
  Output<bandwagon_msgs::msg::FollowRequest> follow_request_;
  Output<bandwagon_msgs::msg::NavigationStatus> status_;
};

}  // namespace bw
