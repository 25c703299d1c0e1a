// Gaps around the footprint at equally spaced times, for searches that ask for very many of them: obstacles
// out of reach are dropped and movers placed beforehand.
#pragma once

#include <vector>

#include "components/model/planning.hpp"

namespace bw {

class TimedGaps {
 public:
  struct Gap {
    double all = 0.0;       ///< [m]; at most `reach`
    double movers = 0.0;    ///< [m] to movers alone; at most `reach`
    std::size_t looks = 0;  ///< pairs of an obstacle and an edge of the footprint looked at
  };

  /// For times 0, step, 2 step, ... up to `horizon` [s] and gaps up to `reach` [m]. Keeps a reference to the
  /// footprint.
  TimedGaps(const PlanningProblem& problem, double horizon, double step, double reach);

  /// At `pose`, which the robot can be at by time `k` * step.
  Gap at(const Pose2& pose, std::size_t k) const;

 private:
  struct Placed {
    Vector2 position;
    double radius;
  };
  /// Everything within `radius` of a-b (a point when a == b).
  struct Core {
    Vector2 a;
    Vector2 b;
    double radius;
  };

  std::size_t cell_of(const Vector2& position) const;

  const Footprint& footprint_;
  double reach_;
  Vector2 corner_{0.0, 0.0};  ///< of the square that the robot cannot leave before the horizon
  int cells_per_side_ = 1;
  std::vector<std::vector<Core>> statics_;   ///< by cell
  std::vector<std::vector<Placed>> movers_;  ///< by time
};

}  // namespace bw
