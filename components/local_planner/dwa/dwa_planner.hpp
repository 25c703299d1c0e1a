// The dynamic window approach (Fox, Burgard, Thrun 1997; theory.md 5.2). Local planners `dwa` and `edwa`
// differ in where heading and speed of the objective come from (heading_source.hpp).
#pragma once

#include <utility>
#include <vector>

#include "components/local_planner/checked_planner.hpp"
#include "components/local_planner/dwa/admissible_samples.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/heading_source.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// Each call: the velocities in reach, of those the ones that can brake before the first contact on their
/// arc, of those the one with the largest G = alpha head + beta dist + gamma vel (3.1), and, by
/// option, from which it can brake clear of where people will be. The footprint counts as a disc. If none is
/// admissible: an evasive move, if one is asked for and clear; else braking with no rotation, status
/// infeasible. Keeps nothing from call to call.
class DwaPlanner final : public CheckedPlanner {
 public:
  /// DWA itself, or with another source of its heading and velocity terms.
  DwaPlanner(const DwaOptions& options, const DrivingOptions& driving)
      : DwaPlanner(options, driving, towards_aim(driving)) {}
  DwaPlanner(const DwaOptions& options, const DrivingOptions& driving, HeadingSource guide)
      : CheckedPlanner(driving), options_(options), guide_(std::move(guide)) {}

 private:
  PlanningResult drive(const PlanningProblem& problem) override;
  void forget() override {}
  void choose(const std::vector<Sample>& samples, const std::vector<double>& scores,
              const PlanningProblem& problem, PlanningResult& result) const;
  bool can_stop_among_movers(const Sample& sample, const PlanningProblem& problem) const;

  DwaOptions options_;
  HeadingSource guide_;
};

}  // namespace bw::dwa
