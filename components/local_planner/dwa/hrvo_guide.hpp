// What EDWA adds to the critics while people matter (theory.md 5.9): the direction and the speed that HRVO
// advises.
#pragma once

#include <optional>

#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/roll_out.hpp"
#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// Could the robot, driving anywhere at v_max, meet somebody who walks within `horizon` [s]? Confirmed movers
/// alone; who stands is in the way as any obstacle is.
bool somebody_within(const PlanningProblem& problem, double horizon);

class HrvoGuide {
 public:
  HrvoGuide(const PlanningProblem& problem, hrvo::Advice advice, const EdwaOptions& options);

  /// HRVO has a direction: it leads.
  bool has_direction() const;
  /// heading_scale times the angle [rad] between that direction and the heading after kHeadingTime, and
  /// advised_speed_scale times the difference of the speeds [m/s].
  double cost(const RollOut& roll_out) const;
  const hrvo::Advice& advice() const { return advice_; }

 private:
  Pose2 pose_;
  hrvo::Advice advice_;
  EdwaOptions options_;
};

}  // namespace bw::dwa
