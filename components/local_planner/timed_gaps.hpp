// Gaps around the footprint at equally spaced times, for searches that ask for very many of them: obstacles
// out of reach are dropped, movers placed beforehand, and what is around a position found once.
#pragma once

#include <vector>

#include <Eigen/Core>

#include "components/model/capsule_index.hpp"
#include "components/model/planning.hpp"

namespace bw {

class TimedGaps {
 public:
  struct Gap {
    double all = 0.0;       ///< [m]
    double movers = 0.0;    ///< [m] to movers alone
    std::size_t looks = 0;  ///< at obstacles, or at groups of them, that it took
  };

  /// For times 0, step, 2 step, ... up to `horizon` [s] and gaps up to `reach` [m]. Keeps a reference to the
  /// footprint.
  TimedGaps(const PlanningProblem& problem, double horizon, double step, double reach);

  /// At `pose`, which the robot can be at by time `k` * step. `known` are gaps that are larger than reach or
  /// were met already: smaller ones are looked for alone, and these come back where there are none. Not for
  /// several threads.
  Gap at(const Pose2& pose, std::size_t k, const Gap& known);
  /// Larger ones are not looked for.
  Gap farthest() const { return {reach_, reach_, 0}; }

 private:
  /// Movers at one time.
  struct Placed {
    Eigen::ArrayXd x, y;
    Eigen::ArrayXd radius;  ///< with that of the disc around the footprint
  };
  /// What is around a cell; found when the robot first comes there.
  struct Around {
    bool found = false;
    std::vector<CapsuleIndex::Group> groups;
  };

  const Around& around(const Vector2& position);

  const Footprint& footprint_;
  double reach_;
  Vector2 corner_{0.0, 0.0};  ///< of the square that the robot cannot leave before the horizon
  int cells_per_side_ = 1;
  CapsuleIndex statics_;
  std::vector<Around> cells_;
  std::vector<Placed> movers_;  ///< by time
};

}  // namespace bw
