// Where the heading and velocity terms of the objective (3.1) come from: the point aimed at (DWA, theory.md
// 5.2), or the velocity that HRVO advises (EDWA, theory.md 5.4). All else is one dynamic window approach.
#pragma once

#include <functional>
#include <optional>

#include "components/local_planner/driving.hpp"
#include "components/local_planner/dwa/admissible_samples.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// What one cycle asks of its samples. Refers to no problem: it may outlive the one it was made for.
struct Guidance {
  std::function<double(const Sample&)> heading_error;   ///< [rad], at most pi either way
  std::function<double(const Sample&)> velocity_score;  ///< [m/s], the larger the better
  std::optional<hrvo::Advice> advice;                   ///< what it rests on, for people to see
};

/// For a sound problem with a plan and the point of the plan that is aimed at.
using HeadingSource = std::function<Guidance(const PlanningProblem& problem, const Vector2& aim)>;

/// DWA: towards the aim from where the sample ends (3.2), and fast. The nearer to the aim a sample ends, the
/// less its bearing from there says: within the arrival tolerance it fades out.
HeadingSource towards_aim(const DrivingOptions& driving);

/// EDWA: towards the direction of HRVO's velocity, at its speed (D5, D6); as DWA when HRVO has no direction.
HeadingSource towards_hrvo(const EdwaOptions& options, const hrvo::HrvoOptions& hrvo,
                           const DrivingOptions& driving);

}  // namespace bw::dwa
