// One path of 12 m, and more and more beside it: what planning takes must not grow with that.
#pragma once

#include <cstdint>

#include "components/model/planning.hpp"

namespace bw {

/// What there is more and more of.
enum class Crowding {
  points,    ///< static points along the walls of a corridor 3.2 m wide, three of them in it
  corridor,  ///< walkers in such a corridor, walls of segments
  hall,      ///< walkers in a hall of 100 x 100 m
};

/// A disc of 0.3 m at the start, at rest; the goal is 12 m ahead. The same seed gives the same scene, with
/// more of `count` around it.
PlanningProblem crowded(Crowding crowding, int count, std::uint64_t seed);

}  // namespace bw
