// V_r = V_s, V_d and V_a together: the velocities in reach from which the robot can still brake (theory.md
// 5.2).
#pragma once

#include <vector>

#include "components/local_planner/dwa/arc.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// A velocity and what holding it leads to.
struct Sample {
  Arc arc;
  double horizon = 0.0;  ///< of the roll-out [s]: sim_time, or until `aim` is as far away as the travel
  double gap = 0.0;      ///< smallest one of the roll-out [m], from 0 to the cap
};

/// Time between two looks at the gap along a roll-out [s].
inline constexpr double kGapStep = 0.1;

/// Beyond this gap [m] all are equal.
double gap_cap(const DwaOptions& options);

/// Samples that can brake before the first contact on their arc, v <= sqrt(2 s_c acc_max) (option
/// hold_before_braking: with one control period of driving on before it), all obstacles standing where they
/// are. teaching_sample: the gap at the end of the roll-out in place of s_c. Towards a final goal also
/// v <= sqrt(2 d acc_max) (option arc_to_goal: and no faster than turning into it allows). The problem must
/// be sound (fault_of) and hold a plan.
std::vector<Sample> admissible_samples(const PlanningProblem& problem, const Vector2& aim,
                                       const DwaOptions& options);

}  // namespace bw::dwa
