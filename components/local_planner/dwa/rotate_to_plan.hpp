// When the plan leads off to the side or backwards: rotate in place until it lies ahead.
#pragma once

#include <optional>

#include "components/local_planner/dwa/critics.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// Once begun it goes on, to the same side, until the plan lies ahead: it does not swing.
class RotateToPlan {
 public:
  /// The angle that is left to rotate [rad]; nothing when the plan lies ahead.
  std::optional<double> angle(const PlanningProblem& problem, const Course& course,
                              const CriticOptions& options);
  void forget() { side_ = 0.0; }

 private:
  double side_ = 0.0;  // that it rotates to: 1 left, -1 right, 0 not at all
};

/// What a rotation in place costs: [rad] between the angle that is wanted and where it comes to rest when
/// `held` is held until a later command takes effect, and stopped then.
double rotation_left_over(const Twist2& held, double angle, const PlanningProblem& problem);

}  // namespace bw::dwa
