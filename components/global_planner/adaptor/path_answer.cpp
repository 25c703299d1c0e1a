#include "components/global_planner/adaptor/path_answer.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "components/messages/geometry.hpp"

namespace bw {
namespace {

/// Each is a search: more than a person would name would block the planner for seconds.
constexpr std::size_t kMostStops = 1000;

PathAnswer refusal(PathError error, std::string reason) {
  return {.is_found = false, .path = {}, .error = error, .reason = std::move(reason)};
}

bool is_planner(const std::string& id, const std::vector<std::string>& plugins) {
  return id.empty() ? plugins.size() == 1 : std::ranges::find(plugins, id) != plugins.end();
}

/// Of what keeps a path from being found. A map that has not come yet is what Nav2 calls a costmap that is late: its tree
/// tries again then.
PathError error_of(PathStatus status) {
  switch (status) {
    case PathStatus::no_map:
      return PathError::timeout;
    case PathStatus::unplaced:
      return PathError::tf_error;
    case PathStatus::start_outside:
      return PathError::start_outside_map;
    case PathStatus::goal_outside:
      return PathError::goal_outside_map;
    case PathStatus::start_blocked:
      return PathError::start_occupied;
    case PathStatus::goal_blocked:
      return PathError::goal_occupied;
    case PathStatus::disconnected:
      return PathError::no_valid_path;
    case PathStatus::bad_request:
    case PathStatus::ok:
      break;
  }
  return PathError::unknown;
}

}  // namespace

PathAnswer answer_question(MapPlanner& planner, PathQuestion question, Time now) {
  RouteRequest& route = question.route;
  route.at_their_stamps = true;
  if (route.stops.empty()) return refusal(PathError::no_viapoints_given, "the goal names no pose to go to");
  if (route.stops.size() > kMostStops)
    return refusal(PathError::unknown, fmt::format("the goal names {} poses, at most {} are planned through",
                                                   route.stops.size(), kMostStops));
  const std::vector<std::string>& plugins = planner.parameters().planner_plugins;
  if (!is_planner(question.planner_id, plugins))
    return refusal(PathError::invalid_planner, fmt::format("planner_id '{}' is none of this server: {}",
                                                           question.planner_id, fmt::join(plugins, ", ")));
  // A pose that is none lies nowhere on the map.
  if (route.start) {
    if (const std::string fault = fault_of(route.start->pose()); !fault.empty())
      return refusal(PathError::start_outside_map, "the start is no pose: " + fault);
    route.start->pose(normalised(route.start->pose()));
  }
  for (std::size_t i = 0; i < route.stops.size(); ++i) {
    if (const std::string fault = fault_of(route.stops[i].pose()); !fault.empty())
      return refusal(PathError::goal_outside_map,
                     fmt::format("pose {} of {} is none: {}", i + 1, route.stops.size(), fault));
    route.stops[i].pose(normalised(route.stops[i].pose()));
  }
  const PathResult result = planner.plan(route, now);
  if (result.status != PathStatus::ok) return refusal(error_of(result.status), result.reason);
  return {.is_found = true, .path = to_path(planner.map_frame(), now, result.path), .reason = {}};
}

}  // namespace bw
