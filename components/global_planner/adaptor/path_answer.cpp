#include "components/global_planner/adaptor/path_answer.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "components/global_planner/adaptor/plan_messages.hpp"
#include "components/messages/geometry.hpp"

namespace bw {
namespace {

/// Each is a search: more than a person would name would block the planner for seconds.
constexpr std::size_t kMaxStops = 1000;

PathAnswer refusal(Nav2ErrorCode error, std::string reason) {
  return {.is_found = false, .path = {}, .error = error, .reason = std::move(reason)};
}

bool is_planner(const std::string& id, const std::vector<std::string>& plugins) {
  return id.empty() ? plugins.size() == 1 : std::ranges::find(plugins, id) != plugins.end();
}

}  // namespace

PathAnswer answer_question(MapPlanner& planner, PathQuestion question, Time now) {
  RouteRequest& route = question.route;
  route.at_their_stamps = true;
  if (route.stops.empty())
    return refusal(compute_path_through_poses_error::kNoViapointsGiven, "the goal names no pose to go to");
  if (route.stops.size() > kMaxStops)
    return refusal(compute_path_error::kUnknown,
                   fmt::format("the goal names {} poses, at most {} are planned through", route.stops.size(),
                               kMaxStops));
  const std::vector<std::string>& plugins = planner.parameters().planner_plugins;
  if (!is_planner(question.planner_id, plugins))
    return refusal(compute_path_error::kInvalidPlanner,
                   fmt::format("planner_id '{}' is none of this server: {}", question.planner_id,
                               fmt::join(plugins, ", ")));
  // Nav2 has no code of its own for what is no pose; tf2, which has to place it in the map, refuses it.
  if (route.start) {
    if (const std::string fault = fault_of(route.start->pose()); !fault.empty())
      return refusal(compute_path_error::kTfError, "the start is no pose: " + fault);
    route.start->pose(normalised(route.start->pose()));
  }
  for (std::size_t i = 0; i < route.stops.size(); ++i) {
    if (const std::string fault = fault_of(route.stops[i].pose()); !fault.empty())
      return refusal(compute_path_error::kTfError,
                     fmt::format("pose {} of {} is none: {}", i + 1, route.stops.size(), fault));
    route.stops[i].pose(normalised(route.stops[i].pose()));
  }
  const PathResult result = planner.plan(route, now);
  if (result.status != PathStatus::ok) return refusal(error_code_of(result.status), result.reason);
  return {.is_found = true, .path = to_path(planner.map_frame(), now, result.path), .reason = {}};
}

}  // namespace bw
