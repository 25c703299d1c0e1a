// The planners of Nav2 behind our navigator: plan_request and follow_request go to planner_server,
// controller_server and behavior_server as goals, and what becomes of them comes back as plan_result and
// follow_status.
#include <cstdint>
#include <map>
#include <string>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>

#include "components/messages/geometry.hpp"
#include "components/nav2_servers/adaptor/plan_relay.hpp"
#include "components/nav2_servers/adaptor/server_actions.hpp"
#include "runtime/component.hpp"

namespace bw {
namespace {

using namespace bandwagon_msgs::msg;

/// A request from outside the known ones stops.
FollowMode mode_of(const FollowRequest& request) {
  const bool is_known = request.mode() <= FollowRequest_Constants::BACK_OFF;
  return is_known ? static_cast<FollowMode>(request.mode()) : FollowMode::stop;
}

class Nav2ServersComponent final : public Component {
 public:
  void configure(Setup& setup) override {
    parameters_ = setup.parameters<Nav2ServersParameters>(
        [this](const Nav2ServersParameters& changed, const Tick&) { parameters_ = changed; });
    map_frame_ = setup.frame("map");
    servers_ = declare_server_actions(setup, parameters_);
    plans_.listen(setup, servers_);
    status_ = setup.output<FollowStatus>("follow_status");
    setup.input<FollowRequest>("follow_request", Qos::standard(),
                               [this](const FollowRequest& request, const Tick& tick) {
                                 path_ = request.path();
                                 relay_.order(request.id(), mode_of(request));
                                 advance(tick);
                               });
    setup.every(Duration::seconds(1.0 / parameters_.rate), "tell", [this](const Tick& tick) {
      advance(tick);
      tell(tick);
    });
  }

  void deactivate(const Tick&) override {
    cancel(relay_.stop());
    goals_.clear();
    plans_.forget();
  }

 private:
  struct SentGoal {
    FollowMode mode;
    GoalId id;
  };

  void advance(const Tick& tick) {
    const RelayActions actions = relay_.step(
        {.follow_path = servers_.follow_path.is_ready(), .back_up = servers_.back_up.is_ready()}, tick.now);
    cancel(actions);
    if (actions.clear_costmap) servers_.clear_local_costmap();
    if (actions.send) send(*actions.send);
    if (relay_.report().state != told_) tell(tick);
  }

  void send(const RelayGoal& goal) {
    const auto on_acknowledged = [this, number = goal.number](bool accepted, const Tick& tick) {
      if (!accepted) cancel({.cancel = {number}});  // its yes may still be on the way
      if (!accepted) goals_.erase(number);
      relay_.acknowledged(number, accepted);
      advance(tick);
    };
    const auto on_end = [this, number = goal.number](const ServerEnd& end, const nav_msgs::msg::Path&,
                                                     const Tick& tick) {
      goals_.erase(number);
      relay_.ended(number, end);
      advance(tick);
    };
    const ServerCallbacks callbacks{on_acknowledged, on_end};
    const BackUpOrder back{parameters_.kBackOffDistance, parameters_.kBackOffSpeed,
                           Duration::seconds(parameters_.kBackOffTime)};
    goals_[goal.number] = {goal.mode, goal.mode == FollowMode::back_off
                                          ? servers_.back_up.send(back, callbacks)
                                          : servers_.follow_path.send(path_, callbacks)};
  }

  void cancel(const RelayActions& actions) {
    for (const std::uint64_t number : actions.cancel) {
      const auto goal = goals_.find(number);
      if (goal == goals_.end()) continue;
      const auto& [mode, id] = goal->second;
      mode == FollowMode::back_off ? servers_.back_up.cancel(id) : servers_.follow_path.cancel(id);
    }
  }

  void tell(const Tick& tick) {
    const FollowReport report = relay_.report();
    FollowStatus status;
    status.header(make_header(map_frame_, tick.now));
    status.id(report.id);
    status.status(static_cast<std::uint8_t>(report.state));
    status.reason(report.reason);
    status.error_code(report.error_code);
    status_.publish(status);
    told_ = report.state;
  }

  Nav2ServersParameters parameters_;
  std::string map_frame_;
  ServerActions servers_;
  PlanRelay plans_;
  DriveRelay relay_;
  std::map<std::uint64_t, SentGoal> goals_;  ///< by the relay's number
  nav_msgs::msg::Path path_;
  FollowState told_ = FollowState::idle;
  Output<FollowStatus> status_;
};

}  // namespace

BW_COMPONENT(Nav2ServersComponent, "nav2_servers")

}  // namespace bw
