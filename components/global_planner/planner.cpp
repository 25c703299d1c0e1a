#include "components/global_planner/planner.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <utility>

#include "components/global_planner/path_shape.hpp"

namespace bw {
namespace {

std::string describe(const char* what, const Pose2& pose, const char* rest) {
  char text[200];
  std::snprintf(text, sizeof text, "%s (%.2f, %.2f) %s", what, pose.x, pose.y, rest);
  return text;
}

GridCell to_cell(const std::pair<int, int>& xy) {
  return {static_cast<std::uint16_t>(xy.first), static_cast<std::uint16_t>(xy.second)};
}

// Calls visit(x, y, squared distance [cells]) for the map's cells with a centre within `reach` [cells] of a
// point.
template <class Visit>
void for_each_cell_around(const SearchGrid& grid, const Vector2& point_in_cells, double reach, Visit visit) {
  const int rows = static_cast<int>(grid.cells().size() / static_cast<std::size_t>(grid.stride()));
  const auto clamped = [](double value, int high) {
    return static_cast<int>(std::clamp(std::floor(value), 1.0, static_cast<double>(high)));
  };
  const int x1 = clamped(point_in_cells.x() + reach, grid.stride() - 2);
  const int y1 = clamped(point_in_cells.y() + reach, rows - 2);
  for (int y = clamped(point_in_cells.y() - reach, rows - 2); y <= y1; ++y) {
    for (int x = clamped(point_in_cells.x() - reach, grid.stride() - 2); x <= x1; ++x) {
      const double squared = (Vector2{x + 0.5, y + 0.5} - point_in_cells).squaredNorm();
      if (squared <= reach * reach) visit(x, y, squared);
    }
  }
}

// The nearest free cell that can be reached from `start` without passing through an obstacle: a robot that
// stands too close to a wall must not appear behind it.
std::optional<GridCell> nearest_free_start(const SearchGrid& grid, const Vector2& start, double tolerance) {
  const GridCell first = to_cell(grid.cell_of(start));
  if (grid.free(first.x, first.y)) return first;
  const Vector2 p = grid.to_cells(start);
  const double reach = tolerance / grid.resolution();
  std::vector<GridCell> reached{first};
  std::vector<char> seen(grid.cells().size(), 0);
  seen[grid.index(first.x, first.y)] = 1;
  std::optional<GridCell> best;
  double best_squared = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < reached.size(); ++i) {
    for (unsigned d = 0; d < 8; d += 2) {
      const int x = reached[i].x + kSteps[d].dx;
      const int y = reached[i].y + kSteps[d].dy;
      const double squared = (Vector2{x + 0.5, y + 0.5} - p).squaredNorm();
      if (squared > reach * reach || grid.clearance(x, y) <= 0.0F) continue;
      if (std::exchange(seen[grid.index(x, y)], char{1}) != 0) continue;
      reached.push_back({static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y)});
      if (grid.free(x, y) && squared < best_squared) {
        best_squared = squared;
        best = reached.back();
      }
    }
  }
  return best;
}

std::optional<GridCell> nearest_goal(const SearchGrid& grid, const Vector2& goal, double tolerance,
                                     std::uint32_t component) {
  std::optional<GridCell> best;
  double best_squared = std::numeric_limits<double>::infinity();
  for_each_cell_around(grid, grid.to_cells(goal), tolerance / grid.resolution(),
                       [&](int x, int y, double squared) {
                         if (squared < best_squared && grid.free(x, y) && grid.component(x, y) == component) {
                           best_squared = squared;
                           best = to_cell({x, y});
                         }
                       });
  return best;
}

bool is_finite_disc(const Disc& disc) { return disc.center.allFinite() && std::isfinite(disc.radius); }

}  // namespace

std::string_view to_string(PathStatus status) {
  switch (status) {
    case PathStatus::ok:
      return "ok";
    case PathStatus::no_map:
      return "no_map";
    case PathStatus::bad_request:
      return "bad_request";
    case PathStatus::unplaced:
      return "unplaced";
    case PathStatus::start_outside:
      return "start_outside";
    case PathStatus::goal_outside:
      return "goal_outside";
    case PathStatus::start_blocked:
      return "start_blocked";
    case PathStatus::goal_blocked:
      return "goal_blocked";
    case PathStatus::disconnected:
      return "disconnected";
  }
  return "unknown";
}

std::string Planner::set_map(const OccupancyGrid& map, const Footprint& footprint,
                             const StaticObstacles& shapes) {
  if (map.width <= 0 || map.height <= 0) return "the map has no cells";
  if (map.width > SearchGrid::kMaxSide || map.height > SearchGrid::kMaxSide) {
    return "the map has more than " + std::to_string(SearchGrid::kMaxSide) + " cells on a side";
  }
  const std::size_t count = static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height);
  if (map.cells.size() != count) return "the map's cells are not width * height";
  if (!std::isfinite(map.resolution) || map.resolution <= 0.0)
    return "the map's resolution is not a positive number";
  if (!map.origin.allFinite()) return "the map's origin is not finite";
  if (!std::isfinite(footprint.radius) || footprint.radius < 0.0)
    return "the robot's radius is not a positive number";
  grid_ = {};
  search_.grid_changed();
  grid_.build(map, footprint, options_, shapes);
  return {};
}

PathResult Planner::plan(const Pose2& start, const Pose2& goal, const std::vector<Disc>& temporary) {
  return plan_through(start, {goal}, temporary);
}

PathResult Planner::plan_through(const Pose2& start, const std::vector<Pose2>& stops,
                                 const std::vector<Disc>& temporary) {
  PathResult result;
  if (grid_.empty()) {
    result.reason = "there is no map yet";
    return result;
  }
  if (!is_finite(start) || !std::ranges::all_of(stops, [](const Pose2& stop) { return is_finite(stop); }) ||
      !std::ranges::all_of(temporary, is_finite_disc)) {
    result.status = PathStatus::bad_request;
    result.reason = "the request holds a number that is not finite";
    return result;
  }
  if (stops.empty()) {
    result.status = PathStatus::bad_request;
    result.reason = "the request names no pose to go to";
    return result;
  }
  grid_.block(temporary);
  result = plan_legs(start, stops, !temporary.empty());
  grid_.unblock();
  return result;
}

PathResult Planner::plan_legs(const Pose2& start, const std::vector<Pose2>& stops, bool has_temporary) {
  PathResult whole = plan_unblocked(start, stops.front(), has_temporary);
  for (std::size_t i = 1; whole.status == PathStatus::ok && i < stops.size(); ++i) {
    // From where the path before ended: a stop may have moved by the tolerance.
    const PathResult leg = plan_unblocked(whole.path.back(), stops[i], has_temporary);
    whole.expanded += leg.expanded;
    if (leg.status != PathStatus::ok) {
      return {.status = leg.status,
              .reason = "on the way to pose " + std::to_string(i + 1) + " of " +
                        std::to_string(stops.size()) + ": " + leg.reason,
              .path = {},
              .expanded = whole.expanded};
    }
    // One pose alone is a rotation where the path before ended.
    if (leg.path.size() == 1) whole.path.back() = leg.path.back();
    whole.path.insert(whole.path.end(), leg.path.begin() + 1, leg.path.end());
    whole.length += leg.length;
    whole.cost += leg.cost;
    whole.goal_offset = leg.goal_offset;
  }
  return whole;
}

PathCheck Planner::check(const std::vector<Pose2>& path, const std::optional<Vector2>& robot,
                         const std::vector<Disc>& temporary) {
  if (grid_.empty()) return {};
  grid_.block(temporary);
  PathCheck result = check_path(grid_, path, robot);
  grid_.unblock();
  return result;
}

PathResult Planner::plan_unblocked(const Pose2& start, const Pose2& goal, bool has_temporary) {
  PathResult result;
  const auto fail = [&result](PathStatus status, std::string reason) {
    result.status = status;
    result.reason = std::move(reason);
    return result;
  };
  if (!grid_.on_map(start.position()))
    return fail(PathStatus::start_outside, describe("start", start, "is off the map"));
  if (!grid_.on_map(goal.position()))
    return fail(PathStatus::goal_outside, describe("goal", goal, "is off the map"));

  const std::optional<GridCell> from = nearest_free_start(grid_, start.position(), options_.start_tolerance);
  if (!from) return fail(PathStatus::start_blocked, describe("start", start, "is too close to an obstacle"));
  const std::uint32_t component = grid_.component(from->x, from->y);
  const GridCell asked = to_cell(grid_.cell_of(goal.position()));
  const bool goal_is_free = grid_.free(asked.x, asked.y);
  std::optional<GridCell> to = asked;
  if (!goal_is_free || grid_.component(asked.x, asked.y) != component) {
    to = nearest_goal(grid_, goal.position(), options_.goal_tolerance, component);
  }
  if (!to && goal_is_free) {
    return fail(PathStatus::disconnected,
                describe("goal", goal, "is free, but no way leads there from the start"));
  }
  if (!to) return fail(PathStatus::goal_blocked, describe("goal", goal, "is too close to an obstacle"));

  const GridPath cells = search_.search(grid_, *from, *to);
  result.expanded = cells.expanded;
  if (cells.cells.empty()) {
    const char* why = cells.too_far   ? "is too far away for the cost counter"
                      : has_temporary ? "cannot be reached while temporary obstacles block the way"
                                      : "is free, but no way leads there from the start";
    return fail(PathStatus::disconnected, describe("goal", goal, why));
  }

  const bool start_moved = *from != to_cell(grid_.cell_of(start.position()));
  const Vector2 first = start_moved ? grid_.position(from->x, from->y) : start.position();
  const bool is_kept = *to == asked && (grid_.narrow(to->x, to->y) == nullptr || grid_.fits(goal));
  const Vector2 last = is_kept ? goal.position() : grid_.position(to->x, to->y);
  std::vector<Vector2> corners = shorten(grid_, cells, first, last);
  if (cells.cells.size() == 1) corners.push_back(last);
  if (start_moved) corners.insert(corners.begin(), start.position());
  for (std::size_t i = 1; i < corners.size(); ++i) result.length += (corners[i] - corners[i - 1]).norm();
  result.path = sample(corners, options_.kSpacing, goal.theta);
  result.cost = grid_.resolution() * cells.cost_so_far.back() / kUnit;
  result.goal_offset = (last - goal.position()).norm();
  result.status = PathStatus::ok;
  return result;
}

}  // namespace bw
