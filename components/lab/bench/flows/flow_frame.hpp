// What flows and encounters have in common: the robot, its corridor, its people. Metres, seconds.
#pragma once

#include <cstdint>

#include "components/lab/bench/flows/social_people.hpp"
#include "components/lab/bench/scene_drive.hpp"

namespace bw {

inline constexpr double kFlowHalfWidth = 2.0;      ///< [m] of the corridor
inline constexpr double kFlowLength = 15.0;        ///< [m] that the robot drives in it
inline constexpr SceneLoop kFlowLoop{-5.0, 20.0};  ///< [m] from wall's end to wall's end
inline constexpr double kFlowAhead = 8.0;          ///< [m] of the path that the planner is given
inline constexpr double kFlowFar = 1000.0;         ///< [m] to the goals of who never arrives

/// Two walls along x.
void add_walls_along(StaticObstacles& walls, double half_width, double from, double to);

/// Along the middle to x = `end`, without walls and people.
DriveScene along_the_middle(const char* name, std::uint64_t seed, double end, double timeout);
/// The same between two walls.
DriveScene in_a_corridor(const char* name, std::uint64_t seed, double half_width, double end, double timeout);

/// Nobody yet, by forces that leave room in doors.
SocialWalkersOptions flow_walkers();

}  // namespace bw
