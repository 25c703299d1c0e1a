// The room of the drawings about sensors: walls and three pillars, as a map and as what a laser meets. Frame:
// map, metres.
#pragma once

#include <vector>

#include "components/lab/figures/plane.hpp"
#include "components/model/obstacles.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::figures {

inline const Eigen::AlignedBox2d kRoom(Vector2(0.0, 0.0), Vector2(10.0, 6.0));

StaticObstacles room_shapes();
/// Cells of 5 cm; those that a shape touches are occupied.
OccupancyGrid room_map();
void draw_room(Plane& plane);

/// Where a robot is after each of `steps` periods of 0.05 s, at 0.8 m/s along a bend through the room.
std::vector<Pose2> path_through_room(int steps);

}  // namespace bw::figures
