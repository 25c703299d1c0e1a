// Whether a path can still be driven on the prepared map.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "components/global_planner/search_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw {

struct PathCheck {
  bool valid = false;  ///< it has poses, and none of them is blocked
  std::vector<std::int32_t>
      blocked;  ///< indices of poses off the map, too close to an obstacle, or not finite
};

/// Looks at the poses (in the map's frame) from the one nearest to `robot` on, as Nav2's planner_server does:
/// what the robot has passed may have become blocked since. Without `robot` at all of them. Poses alone, not
/// what lies between them.
PathCheck check_path(const SearchGrid& grid, const std::vector<Pose2>& path,
                     const std::optional<Vector2>& robot);

}  // namespace bw
