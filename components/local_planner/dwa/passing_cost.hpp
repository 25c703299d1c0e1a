// What holding a velocity costs for how near it passes people who walk (book 5.9).
#pragma once

#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/roll_out.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// The robot among confirmed movers that walk, and nothing else: whatever stands is met by the other roll-outs. Plan and obstacles, the
/// large parts, are not copied.
PlanningProblem walkers_alone(const PlanningProblem& problem);

/// For one problem of walkers_alone(), which must outlive it. Every velocity is held for mover_horizon, and at each of its moments people are where they are
/// expected then.
class PassingCost {
 public:
  PassingCost(const PlanningProblem& walkers, const EdwaOptions& options);

  /// passing_scale times s^passing_power (1 - passing_fading t / mover_horizon), s the share of passing_gap that is missing at the smallest
  /// gap, t when that is [s]; when it touches, s is that of 0.3 m within, and 1 - t / mover_horizon comes on top.
  double of(const Twist2& held);

 private:
  EdwaOptions options_;
  RollOuts roll_outs_;
};

}  // namespace bw::dwa
