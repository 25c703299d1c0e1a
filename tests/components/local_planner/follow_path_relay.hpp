// Stands between navigator and local planner as Nav2's behaviour tree does: each path that is ordered becomes
// a goal of follow_path. What is no path goes on as it came.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <bandwagon_msgs/msg/follow_request.hpp>
#include <bandwagon_msgs/msg/follow_status.hpp>
#include <nav2_msgs/action/follow_path.hpp>

#include "runtime/component.hpp"

namespace bw {

class FollowPathRelay final : public Component {
 public:
  static inline int goals_taken = 0;  ///< by the action, of all relays

  void configure(Setup& setup) override {
    namespace mode = bandwagon_msgs::msg::FollowRequest_Constants;
    client_ = setup.action_client<Action>("follow_path");
    forward_ = setup.output<Request>("relayed_request");
    status_ = setup.output<Status>("follow_status");
    setup.input<Request>("follow_request", Qos::standard(), [this](const Request& request, const Tick&) {
      if (request.mode() == mode::FOLLOW) return follow(request);
      if (goal_) client_.cancel(*goal_);
      goal_.reset();
      is_followed_ = false;
      forward_.publish(request);
    });
    setup.input<Status>("planner_status", Qos::standard(), [this](const Status& status, const Tick&) {
      Status out = is_followed_ ? own_ : status;
      out.header(status.header());
      status_.publish(out);
    });
  }

 private:
  using Action = nav2_msgs::action::FollowPath;
  using Request = bandwagon_msgs::msg::FollowRequest;
  using Status = bandwagon_msgs::msg::FollowStatus;

  void follow(const Request& request) {
    namespace follow = bandwagon_msgs::msg::FollowStatus_Constants;
    Action::Goal goal;
    goal.path(request.path());
    const std::uint64_t id = request.id();
    own_ = {};
    own_.id(id);
    own_.status(follow::FOLLOWING);
    is_followed_ = true;
    goal_ =
        client_.send(goal, Duration::milliseconds(500),
                     {.on_acknowledged = [](bool accepted, const Tick&) { goals_taken += accepted ? 1 : 0; },
                      .on_feedback = nullptr,
                      .on_result =
                          [this, id](GoalStatus status, const Action::Result* result, const Tick&) {
                            if (own_.id() != id || status == GoalStatus::succeeded) return;
                            own_.status(follow::BLOCKED);
                            own_.reason(result == nullptr ? "the server is gone" : result->error_msg());
                          }});
  }

  ActionClient<Action> client_;
  Output<Request> forward_;
  Output<Status> status_;
  std::optional<GoalId> goal_;
  bool is_followed_ = false;  ///< the last order was a path
  Status own_;                ///< of that path
};

}  // namespace bw
