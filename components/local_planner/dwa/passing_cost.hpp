// What holding a velocity costs for how near it passes people who walk (theory.md 5.9).
#pragma once

#include <optional>

#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/roll_out.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// The robot among confirmed movers that walk, and nothing else: whatever stands is met by the other
/// roll-outs. Plan and obstacles, the large parts, are not copied.
PlanningProblem walkers_alone(const PlanningProblem& problem);

/// For one problem of walkers_alone(). Every velocity is held for mover_horizon, and at each of its moments
/// people are where they are expected then.
class PassingCost {
 public:
  PassingCost(const PlanningProblem& walkers, const EdwaOptions& options);

  /// The larger of two: of people who walk at v_max or faster, whom the robot cannot get away from later, and
  /// of slower ones. s is the share of passing_gap that is missing at the smallest gap, t when that is [s];
  /// passing_scale times s of the former, and s^passing_power (1 - passing_fading t / mover_horizon) of the
  /// latter. When it touches, s is that of 0.3 m within, and 1 - t / mover_horizon comes on top.
  double of(const Twist2& held);

 private:
  /// Some of the walkers.
  struct Group {
    Group(PlanningProblem among, const EdwaOptions& options);
    Group(const Group&) = delete;
    Group& operator=(const Group&) = delete;

    double cost(const Twist2& held, const EdwaOptions& options, double power, double fading);

    PlanningProblem problem;
    RollOuts roll_outs;
  };

  EdwaOptions options_;
  std::optional<Group> fast_, slow_;  // where there are any
};

}  // namespace bw::dwa
