// A stretch of the drive whose scans were matched among themselves: one rigid piece of the map.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "components/slam/finished_walls.hpp"
#include "components/slam/scan.hpp"
#include "components/slam/uncertain_pose.hpp"

namespace bw::slam {

/// Submaps overlap by half: while one is matched against, the next is begun. S: a submap's frame, the pose at
/// which it was begun.
struct Submap {
  UncertainPose X_PS;  ///< in the parent
  FinishedWalls surfaces;
  std::size_t first_node = 0;  ///< number of the first scan of the map that went into it
  std::size_t last_node = 0;   ///< and of the one after the last
  /// What its walls say along the direction of which they say least, as a share of what they say across it: 0
  /// (a corridor) to 1.
  double all_round = 0.0;
  Vector2 centre{0.0, 0.0};  ///< of its walls [m]: a scanner that looks ahead maps what lies before the robot
  /// P: nothing for the submap before; where a map is continued, that in which the robot found itself.
  std::optional<std::size_t> found_in;

  /// Left out of map and graph, without surfaces (sparsification.hpp): where it lies in one that is still there.
  struct Anchor {
    std::size_t submap = 0;
    Pose2 X_AS;
  };
  std::optional<Anchor> marginalised;

  /// Index of P, of submap `index` > 0.
  std::size_t parent(std::size_t index) const { return found_in.value_or(index - 1); }
};

/// Where the robot was: in the submap that was matched against, and how far on the way to the next.
struct Placement {
  std::size_t submap = 0;
  Pose2 X_SB;
  double share = 0.0;  ///< 0 where the next submap was begun, 1 where this one ended
};

/// A scan of the map.
struct Node {
  Time time;
  Placement placement;
  std::shared_ptr<const RangeImage> ranges;
};

/// Scans of the map by number, which counts those that came. They leave with the submap that they lie in, and do not
/// move in memory.
using Nodes = std::map<std::size_t, Node>;

}  // namespace bw::slam
