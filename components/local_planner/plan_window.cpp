#include "components/local_planner/plan_window.hpp"

#include <limits>

namespace bw {
namespace {

/// Looking for the nearest pose stops this far along the plan, so that a later stretch close by is no
/// shortcut [m].
constexpr double kSearchLength = 3.0;

double distance(const Pose2& a, const Pose2& b) { return (a.position() - b.position()).norm(); }

std::size_t nearest_index(const std::vector<Pose2>& plan, const Pose2& robot, std::size_t from) {
  std::size_t nearest = from;
  double smallest = std::numeric_limits<double>::infinity();
  double travelled = 0.0;
  for (std::size_t i = from; i < plan.size(); ++i) {
    if (i > from) travelled += distance(plan[i - 1], plan[i]);
    if (travelled > kSearchLength) break;
    if (const double d = distance(plan[i], robot); d < smallest) {
      smallest = d;
      nearest = i;
    }
  }
  return nearest;
}

}  // namespace

PlanWindow plan_window(const std::vector<Pose2>& plan, const Pose2& robot, double lookahead,
                       std::size_t& start_hint) {
  PlanWindow window;
  if (plan.empty()) return window;
  start_hint = nearest_index(plan, robot, std::min(start_hint, plan.size() - 1));
  window.distance_to_goal = distance(robot, plan[start_hint]);
  for (std::size_t i = start_hint; i < plan.size(); ++i) {
    if (i > start_hint) window.distance_to_goal += distance(plan[i - 1], plan[i]);
    if (window.goal_is_final) {
      window.poses.push_back(plan[i]);
      window.goal_is_final = window.distance_to_goal < lookahead || i + 1 == plan.size();
    }
  }
  return window;
}

}  // namespace bw
