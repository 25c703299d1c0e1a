// Whom the rule looks at: the nearest movers and static obstacles, all as one shape.
#pragma once

#include <vector>

#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/model/planning.hpp"

namespace bw::hrvo {

/// Everything within `radius` of a core (a point for discs: a == b), where the robot is a point. [m], [m/s],
/// planning frame.
struct Neighbour {
  Segment core;
  double radius = 0.0;  ///< of robot and neighbour together, with the margin
  Vector2 velocity{0.0, 0.0};
  bool shares = false;    ///< does half of the avoiding
  double distance = 0.0;  ///< of the robot from the core
};

/// The nearest max_neighbours confirmed movers (local_planner/theory.md 7.10) within range and view, nearest
/// first (by gap).
std::vector<Neighbour> moving_neighbours(const PlanningProblem& problem, const HrvoOptions& options);

/// The nearest max_neighbours static obstacles within range and view, nearest first (by gap).
///
/// Beyond what was published (theory.md 5.3): what the robot cannot meet on a path as long as the one to
/// `goal` does not count, neither whole obstacles nor the far parts of a wall (else no velocity towards a
/// wall is ever free); the margin is at most the room there is for the robot now and at the end of a final
/// plan, so that a goal near a wall can be reached and left.
std::vector<Neighbour> static_neighbours(const PlanningProblem& problem, const Vector2& goal,
                                         const HrvoOptions& options);

/// Both, nearest first (by gap).
std::vector<Neighbour> neighbours(const PlanningProblem& problem, const Vector2& goal,
                                  const HrvoOptions& options);

}  // namespace bw::hrvo
