// Frontiers of a map that grows: where what is known to be free borders on what nobody has seen (Yamauchi 1997), and
// where a robot can stand to look beyond. Frame: the map's.
#pragma once

#include <vector>

#include "components/model/occupancy_grid.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::explore {

/// Neighbouring free cells that each touch an unknown one, and that the robot could stand on if what is unknown were
/// free.
struct Frontier {
  Vector2 centre{0.0, 0.0};  ///< one of its cells, the nearest to their mean
  double length = 0.0;       ///< cells times their edge [m]
  Pose2 goal;                ///< as near as it comes without touching what is unknown, facing the centre
  double path_length = 0.0;  ///< from the robot to the centre, gaps between beams included [m]
};

struct FrontierOptions {
  double radius = 0.2;        ///< of a disc about base_link that holds the robot [m]
  double least_length = 0.2;  ///< of a frontier [m]: shorter ones are gaps between beams
};

struct FrontierSearch {
  std::vector<Frontier> frontiers;    ///< with a goal, by path_length
  std::vector<Vector2> out_of_reach;  ///< centres of those that the robot cannot come near enough to
  bool is_placed = false;             ///< the robot stands on known free ground, or next to it
};

/// Same arguments, same result. Cells from 65 on are occupied. Linear in the cells but for the path lengths, which are
/// a wavefront over 8 neighbours (Dijkstra).
FrontierSearch find_frontiers(const OccupancyGrid& map, const Vector2& robot, const FrontierOptions& options);

}  // namespace bw::explore
