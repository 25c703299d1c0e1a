#include "components/global_planner/path_check.hpp"

#include <limits>

namespace bw {
namespace {

/// The first of the nearest ones; NaN is far from everything.
std::size_t nearest_pose(const std::vector<Pose2>& path, const Vector2& robot) {
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const double squared = (path[i].position() - robot).squaredNorm();
    if (!(squared < least)) continue;
    least = squared;
    nearest = i;
  }
  return nearest;
}

bool is_free(const SearchGrid& grid, const Pose2& pose) {
  if (!is_finite(pose) || !grid.on_map(pose.position())) return false;
  const auto [x, y] = grid.cell_of(pose.position());
  return grid.free(x, y) && (grid.narrow(x, y) == nullptr || grid.holds(pose.position()));
}

}  // namespace

PathCheck check_path(const SearchGrid& grid, const std::vector<Pose2>& path,
                     const std::optional<Vector2>& robot) {
  PathCheck check;
  if (grid.empty()) return check;
  for (std::size_t i = robot ? nearest_pose(path, *robot) : 0; i < path.size(); ++i) {
    if (!is_free(grid, path[i])) check.blocked.push_back(static_cast<std::int32_t>(i));
  }
  check.valid = !path.empty() && check.blocked.empty();
  return check;
}

}  // namespace bw
