#include "runtime/action.hpp"

namespace bw {

RequestHandler cancel_goal_handler(ActionPort& port) {
  using action_msgs::srv::CancelGoal;
  return request_handler<CancelGoal>(
      port.cancel_goal_port(),
      [&port](const CancelGoal::Request& request, const Tick& tick) {
        const auto& info = request.goal_info();
        const CanceledGoals canceled =
            port.cancel({.id = info.goal_id().uuid(), .stamp = from_stamp(info.stamp())}, tick.now);
        CancelGoal::Response response;
        response.return_code(static_cast<std::int8_t>(canceled.code));
        for (const CanceledGoals::Goal& goal : canceled.goals) {
          auto& one = response.goals_canceling().emplace_back();
          one.goal_id().uuid(goal.id);
          one.stamp(to_stamp(goal.accepted));
        }
        return response;
      },
      [](const std::string&) {
        CancelGoal::Response response;
        response.return_code(action_msgs::srv::CancelGoal_Response_Constants::ERROR_REJECTED);
        return response;
      });
}

}  // namespace bw
