// plan_request as a goal of planner_server, its end as plan_result.
#pragma once

#include <cstdint>
#include <string>

#include <bandwagon_msgs/msg/plan_request.hpp>
#include <bandwagon_msgs/msg/plan_result.hpp>

#include "components/nav2_servers/adaptor/server_actions.hpp"
#include "runtime/component.hpp"

namespace bw {

class PlanRelay {
 public:
  /// The servers outlive this.
  void listen(Setup& setup, const ServerActions& servers);
  /// Answers that come are nobody's.
  void forget() { awaited_ = 0; }

 private:
  void ask(const bandwagon_msgs::msg::PlanRequest& request, const Tick& tick);
  void on_end(std::uint64_t id, const ServerEnd& end, const nav_msgs::msg::Path& path, const Tick& tick);
  void fail(std::uint64_t id, PlanOutcome outcome, const std::string& reason, const Tick& tick,
            std::uint16_t error_code = 0);
  void answer(bandwagon_msgs::msg::PlanResult result, std::uint64_t id, const Tick& tick);

  const ServerActions* servers_ = nullptr;
  std::string map_frame_;
  std::uint64_t awaited_ = 0;  ///< id of the newest request; 0: none
  Output<bandwagon_msgs::msg::PlanResult> result_;
};

}  // namespace bw
