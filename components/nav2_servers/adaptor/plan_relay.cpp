#include "components/nav2_servers/adaptor/plan_relay.hpp"

#include <utility>

#include "components/messages/geometry.hpp"

namespace bw {

using namespace bandwagon_msgs::msg;

void PlanRelay::listen(Setup& setup, const ServerActions& servers) {
  servers_ = &servers;
  map_frame_ = setup.frame("map");
  result_ = setup.output<PlanResult>("plan_result");
  setup.input<PlanRequest>("plan_request", Qos::standard(),
                           [this](const auto& request, const Tick& tick) { ask(request, tick); });
}

void PlanRelay::ask(const PlanRequest& request, const Tick& tick) {
  const std::uint64_t id = awaited_ = request.id();
  if (!servers_->compute_path.is_ready())
    return fail(id, PlanOutcome::failed, "there is no planner_server", tick);
  const auto on_acknowledged = [this, id](bool accepted, const Tick& now) {
    if (!accepted) fail(id, PlanOutcome::failed, "planner_server does not take the goal", now);
  };
  servers_->compute_path.send(
      request, {.on_acknowledged = on_acknowledged,
                .on_end = [this, id](const ServerEnd& end, const nav_msgs::msg::Path& path, const Tick& now) {
                  on_end(id, end, path, now);
                }});
}

void PlanRelay::on_end(std::uint64_t id, const ServerEnd& end, const nav_msgs::msg::Path& path,
                       const Tick& tick) {
  if (id != awaited_) return;
  const std::string& frame = path.header().frame_id();
  if (end.status != GoalStatus::succeeded) {
    servers_->clear_global_costmap();
    return fail(id, outcome_of(end.error_code), failure_sentence("planner_server", end), tick,
                end.error_code);
  }
  if (frame != map_frame_)
    return fail(id, PlanOutcome::bad_request,
                "planner_server plans in frame '" + frame + "' instead of '" + map_frame_ + "'", tick);
  PlanResult result;
  result.path(path);
  answer(std::move(result), id, tick);
}

void PlanRelay::fail(std::uint64_t id, PlanOutcome outcome, const std::string& reason, const Tick& tick,
                     std::uint16_t error_code) {
  PlanResult result;
  result.status(static_cast<std::uint8_t>(outcome));
  result.reason(reason);
  result.error_code(error_code);
  answer(std::move(result), id, tick);
}

void PlanRelay::answer(PlanResult result, std::uint64_t id, const Tick& tick) {
  if (id != std::exchange(awaited_, 0)) return;
  result.header(make_header(map_frame_, tick.now));
  result.id(id);
  result_.publish(result);
}

}  // namespace bw
