// The corridor of T-MPC's experiments (de Groot et al. 2024): 6 m wide for the robot, people who come and go the same way
// (bench/protocols.md 8.15). Frame: x along it, the robot starts at the origin. Metres, seconds.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/lab/bench/corridor/pedsim_people.hpp"
#include "components/model/limits.hpp"

namespace bw {

inline constexpr double kCorridorHalfWidth = 3.0;      ///< [m] for the robot
inline constexpr double kCorridorPeopleWalls = 3.5;    ///< [m] from the middle
inline constexpr double kCorridorEnd = 25.0;           ///< [m] along x
inline constexpr double kCorridorTimeout = 30.0;       ///< [s]
inline constexpr double kCorridorRobotRadius = 0.325;  ///< [m]
inline constexpr double kCorridorPersonRadius = 0.3;   ///< [m]
inline constexpr int kCrossingPeople = 16;
inline constexpr double kCorridorUnscored = 1.0;  ///< [s] at the start in which a contact does not count

/// v_max is the reference speed, 2 m/s; braking is harder than speeding up, as the peers' fallback brakes.
Limits corridor_limits();

/// `people` of seed 1, 2, ...; the same seed with fewer people has the first of them.
DriveScene corridor_scene(int people, std::uint64_t seed);
std::vector<PedsimPerson> corridor_people(int people, std::uint64_t seed);

/// Who keeps their velocity and sees nobody: from box to box in the corridor, or over three sidewalks across it.
DriveScene straight_corridor_scene(int people, std::uint64_t seed);
DriveScene crossing_scene(std::uint64_t seed);
/// One, two and three people who cross, each scene the same always.
std::vector<DriveScene> fixed_crossings();

}  // namespace bw
