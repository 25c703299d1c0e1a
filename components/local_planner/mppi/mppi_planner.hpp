// Local planner `mppi`: the sampling controller that Nav2 ships, as a peer from outside (theory.md 5.8).
#pragma once

#include "components/local_planner/checked_planner.hpp"
#include "components/local_planner/mppi/mppi_options.hpp"
#include "components/local_planner/mppi/optimizer.hpp"
#include "components/model/planning.hpp"

namespace bw::mppi {

/// Each call: the motion of the last one, shifted by the control period, improved by one round of samples;
/// its velocity at command_lead, as far as that can be reached. When every sample collides: a stop, status
/// infeasible, or, with check_motion, an evasive move. The footprint counts as a disc.
class MppiPlanner final : public CheckedPlanner {
 public:
  MppiPlanner(const MppiOptions& options, const DrivingOptions& driving)
      : CheckedPlanner(driving), options_(options), optimizer_(options) {}

 private:
  PlanningResult drive(const PlanningProblem& problem) override;
  void forget() override { optimizer_.reset(); }
  void remember(const CheckedPlanner& earlier) override {
    if (const auto* other = dynamic_cast<const MppiPlanner*>(&earlier))
      optimizer_.continue_from(other->optimizer_);
  }
  void show_candidates(const PlanningProblem& problem, PlanningResult& result) const;

  MppiOptions options_;
  Optimizer optimizer_;
};

}  // namespace bw::mppi
