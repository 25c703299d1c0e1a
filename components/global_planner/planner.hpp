// The global planner: a map once, then paths on it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "components/global_planner/astar.hpp"
#include "components/global_planner/options.hpp"
#include "components/global_planner/path_check.hpp"
#include "components/global_planner/search_grid.hpp"
#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

enum class PathStatus {
  ok,
  no_map,         ///< set_map was not called, or refused its map
  bad_request,    ///< a number of the request is not finite
  unplaced,       ///< where the start or a stop is on the map is not known
  start_outside,  ///< the start is off the map
  goal_outside,   ///< the same for the goal
  start_blocked,  ///< the start is too close to obstacles, and so is everything within the tolerance
  goal_blocked,   ///< the same for the goal
  disconnected,   ///< start and goal are free, but nothing joins them
};

std::string_view to_string(PathStatus status);

struct PathResult {
  PathStatus status = PathStatus::no_map;
  std::string reason;  ///< one sentence when status is not ok
  std::vector<Pose2>
      path;  ///< in the map's frame, from the start to the goal (or as near as the tolerance allows)
  double length = 0.0;       ///< [m]
  double cost = 0.0;         ///< of the cells searched [free metres]
  double goal_offset = 0.0;  ///< distance of the path's end from the goal asked for [m]
  std::size_t expanded = 0;  ///< cells the search visited
};

class Planner {
 public:
  Planner() = default;
  explicit Planner(const GlobalPlannerOptions& options) : options_(options) {}

  /// What the map was prepared with (clearance, what is an obstacle) stays until the next map.
  void set_options(const GlobalPlannerOptions& options) { options_ = options; }

  /// Prepares a map, and exact `shapes` beside its cells (in the map's frame), for a robot. Returns why it
  /// cannot be used (sizes, numbers), or nothing. The map before stays when it cannot.
  std::string set_map(const OccupancyGrid& map, const Footprint& footprint,
                      const StaticObstacles& shapes = {});

  /// Path from `start` to `goal`, around `temporary` discs (people who stand in the way) as well.
  PathResult plan(const Pose2& start, const Pose2& goal, const std::vector<Disc>& temporary = {});

  /// Path from `start` through all `stops` but the last, in their order, to the last. It is whole or not
  /// there: what keeps it from a stop is the result. Without stops it is a bad request.
  PathResult plan_through(const Pose2& start, const std::vector<Pose2>& stops,
                          const std::vector<Disc>& temporary = {});

  /// check_path() with `temporary` discs in the way as well.
  PathCheck check(const std::vector<Pose2>& path, const std::optional<Vector2>& robot,
                  const std::vector<Disc>& temporary = {});

  const SearchGrid& grid() const { return grid_; }

 private:
  PathResult plan_legs(const Pose2& start, const std::vector<Pose2>& stops, bool has_temporary);
  PathResult plan_unblocked(const Pose2& start, const Pose2& goal, bool has_temporary);

  GlobalPlannerOptions options_;
  SearchGrid grid_;
  AStar search_;
};

}  // namespace bw
