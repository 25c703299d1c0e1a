// Exploring without errors: a robot that goes by the shortest path to what `explore` tells it, and a map that is right at
// once. For comparing choices of the next frontier in many buildings; whole robots: explore_drive.hpp.
#pragma once

#include "components/lab/bench/explore/coverage.hpp"

namespace bw {

struct IdealExploration {
  bool complete = false;  ///< else it took longer than `longest`
  double travel = 0.0;    ///< until it was [m]
  double known = 0.0;     ///< share of the cells to explore
  std::size_t goals = 0;
  std::size_t left = 0;  ///< frontiers that it gave up
};

struct IdealExplorationOptions {
  double radius = 0.18;  ///< of the robot [m]
  double range = 12.0;   ///< of its laser [m]
  double speed = 0.4;    ///< [m/s]
  double period = 2.0;   ///< from map to map [s]
  double longest = 7200.0;
};

/// Same arguments, same figures.
IdealExploration explore_ideally(const Explorable& place, const IdealExplorationOptions& options);

}  // namespace bw
