// Local planner `orca`: the velocity of optimal reciprocal collision avoidance (theory.md 5.6), followed by a
// base that has to turn. A peer from outside, beside `hrvo`.
#pragma once

#include "components/local_planner/checked_planner.hpp"
#include "components/local_planner/orca/orca_options.hpp"
#include "components/model/planning.hpp"

namespace bw::orca {

/// Each call: the advised velocity towards the point of the plan `lookahead` ahead, driven by track_velocity.
/// Remembers nothing.
class OrcaPlanner final : public CheckedPlanner {
 public:
  OrcaPlanner(const OrcaOptions& options, const DrivingOptions& driving)
      : CheckedPlanner(driving), options_(options) {}

 private:
  PlanningResult drive(const PlanningProblem& problem) override;
  void forget() override {}

  OrcaOptions options_;
};

}  // namespace bw::orca
