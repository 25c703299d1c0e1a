// Optimal reciprocal collision avoidance (theory.md 5.6; van den Berg, Guy, Lin, Manocha 2011): the velocity
// of one disc among moving discs and walls. All in one frame; SI units.
#pragma once

#include <cstdint>
#include <vector>

#include "components/local_planner/orca/linear_program.hpp"
#include "components/model/obstacles.hpp"

namespace bw::orca {

/// How far the rule looks.
struct Rule {
  double neighbour_range = 10.0;     ///< [m] between centres
  std::int64_t max_neighbours = 10;  ///< the nearest ones
  double horizon = 5.0;              ///< [s] clear of neighbours
  double wall_horizon = 5.0;         ///< [s] clear of walls
  double time_step = 0.25;           ///< [s] in which an overlap ends
};

/// Who decides.
struct Agent {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double radius = 0.3;
  Vector2 wanted{0.0, 0.0};  ///< velocity
  double v_max = 1.0;
};

struct Neighbour {
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double radius = 0.3;
  double share = 0.5;  ///< of the change that the agent makes; 1: the neighbour does not react
};

/// A wall that the agent's centre keeps `radius` from.
struct Wall {
  Segment core;
  double radius = 0.3;
};

struct Advice {
  Vector2 velocity{0.0, 0.0};          ///< [m/s], at most v_max
  bool free = true;                    ///< within all half planes
  std::vector<HalfPlane> half_planes;  ///< of the walls, then of the neighbours, each nearest first
};

/// The neighbours' half planes may be violated when there is no other way, those of the walls never. The
/// order of `neighbours` and `walls` does not matter.
Advice advise(const Agent& agent, const std::vector<Neighbour>& neighbours, const std::vector<Wall>& walls,
              const Rule& rule);

}  // namespace bw::orca
