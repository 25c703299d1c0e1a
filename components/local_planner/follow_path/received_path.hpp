// A path that somebody else planned, made into one that the local planner can work on.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

struct ReceivedPath {
  std::vector<Pose2> poses;
  std::vector<std::size_t> index;  ///< of each of `poses` in the path as it came
  std::string fault;               ///< one sentence why it cannot be followed; then there are no poses
};

/// Headings follow the path, since planners such as Nav2's NavFn leave them at 0; the last pose keeps its
/// own, which is the goal's. Poses closer than 1 cm to the one before are left out, so that the work of a
/// cycle is bounded by the length of the path and not by how finely it was sampled.
ReceivedPath received_path(const std::vector<Pose2>& path);

/// How a robot at `X_PB` in the path's frame stands to the pose `index` of a path: beside it (left is
/// positive) [m], and by how much the path's direction there is to the left of the robot's [rad].
struct PathOffset {
  double position = 0.0;
  double heading = 0.0;
};
PathOffset path_offset(const std::vector<Pose2>& poses, std::size_t index, const Pose2& X_PB);

}  // namespace bw
