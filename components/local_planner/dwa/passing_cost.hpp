// What holding a velocity costs for how near it passes people who walk (book 5.9).
#pragma once

#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/roll_out.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// The problem with confirmed movers that walk, and nothing else: whatever stands is met by the other roll-outs.
PlanningProblem with_walkers_alone(const PlanningProblem& problem);

/// For one planning problem. Every velocity is held for mover_horizon, and at each of its moments people are where they are
/// expected then.
class PassingCost {
 public:
  PassingCost(const PlanningProblem& problem, const EdwaOptions& options);

  /// passing_scale times: 0 when the smallest gap is passing_gap or more, 1 when it touches at the end of the horizon, and up to 2 when
  /// it touches at once.
  double of(const Twist2& held);

 private:
  EdwaOptions options_;
  RollOuts roll_outs_;
};

}  // namespace bw::dwa
