// Local planner `teb`: one timed elastic band, kept from cycle to cycle (spec 6.1, 6.6).
#pragma once

#include "components/local_planner/teb/band.hpp"
#include "components/local_planner/teb/band_optimizer.hpp"
#include "components/local_planner/teb/teb_options.hpp"
#include "components/model/planning.hpp"

namespace bw::teb {

/// Each call: cut the last band to where the robot is (or start a new one along the plan), optimise it among
/// the obstacles, trust it only if the footprint is free for the next feasibility_check_time, and command the
/// velocity its start asks for after one control period. If it is not free, or a long detour, it is
/// compared with a new band; if neither is free: an evasive move,
/// then a stop (status infeasible).
class TebPlanner final : public LocalPlanner {
 public:
  explicit TebPlanner(const TebOptions& options) : options_(options) {}

  PlanningResult plan(const PlanningProblem& problem) override;
  void reset() override;

 private:
  // One band, optimised and checked.
  struct Attempt {
    Band band;
    BandReport report;
    std::vector<TrajectoryPoint> trajectory;
    bool free = false;

    bool better_than(const Attempt& other) const;
  };

  bool keep_band(const PlanningProblem& problem);
  Attempt improve(Band band, const PlanningProblem& problem, const ObstacleField& field, int budget) const;
  bool is_free(const PlanningProblem& problem, const std::vector<TrajectoryPoint>& trajectory) const;
  PlanningResult arrive(const PlanningProblem& problem) const;
  void evade(const PlanningProblem& problem, PlanningResult& result) const;

  TebOptions options_;
  Band band_;
  Time planned_at_;
  Pose2 goal_;
  bool arrived_ = false;
};

}  // namespace bw::teb
