// PTEB's term of the selection (theory.md 6.4, (3.12)): how far a band leads away from the direction that
// the hybrid reciprocal velocity obstacles advise.
#pragma once

#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/local_planner/teb/choice_term.hpp"
#include "components/local_planner/teb/obstacle_field.hpp"

namespace bw::teb {

/// delta_hrvo of (3.12): cost per radian between a band and the HRVO direction.
inline constexpr double kHrvoAngleWeight = 0.5;

/// weight * |angle between the advised velocity and the direction to zeta_p|, where zeta_p is the point of
/// `trajectory` nearest to an obstacle within the first 4 m, or 2 m ahead when none is near. 0 when the
/// advice is to stand.
double hrvo_cost(const hrvo::Advice& advice, const std::vector<TrajectoryPoint>& trajectory,
                 const ObstacleField& field, double weight);

/// hrvo_cost of every candidate against the advice for the path to the end of the plan. `weight`: delta_hrvo
/// of (3.12), per radian.
ChoiceTermSource hrvo_preference(const hrvo::HrvoOptions& hrvo, double weight);

}  // namespace bw::teb
