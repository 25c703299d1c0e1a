// Local planners on timed elastic bands, kept from cycle to cycle (theory.md 6.1 to 6.7). What tells `teb`,
// `teb_homotopy`, `pteb` and `eteb` apart is composed in band_planners.cpp.
#pragma once

#include <utility>
#include <vector>

#include "components/local_planner/checked_planner.hpp"
#include "components/local_planner/teb/band_candidate.hpp"
#include "components/local_planner/teb/band_selection.hpp"
#include "components/local_planner/teb/band_source.hpp"
#include "components/local_planner/teb/choice_term.hpp"
#include "components/local_planner/teb/prediction_options.hpp"
#include "components/local_planner/teb/teb_options.hpp"

namespace bw::teb {

/// What makes one of these planners; the defaults are those of `teb`.
struct BandPlannerOptions {
  DrivingOptions driving;
  TebOptions teb;
  PredictionOptions field;         ///< how movers enter the field of obstacles
  BandSource source = one_band();  ///< where new bands come from
  SelectionOptions selection;      ///< which of them is driven
  ChoiceTermSource term;           ///< what the choice costs besides; empty: nothing
};

/// Each call: cut the bands of the last cycle to where the robot is, add new ones along the plan and in
/// topologies not held yet, optimise them among the obstacles, and drive the cheapest whose footprint is free
/// for the next feasibility_check_time; the command is the velocity its start asks for after command_lead. If
/// that is an old band and not free, or a long detour, a new band along the plan competes. If none is free:
/// an evasive move, then a stop (status infeasible).
class BandPlanner final : public CheckedPlanner {
 public:
  explicit BandPlanner(BandPlannerOptions options)
      : CheckedPlanner(options.driving), options_(std::move(options)) {}

 private:
  /// What one call of drive() has found out so far.
  struct Cycle;

  PlanningResult drive(const PlanningProblem& problem) override;
  void forget() override;
  void remember(const CheckedPlanner& earlier) override;

  /// The bands of the last cycle from where the robot is now.
  std::vector<BandCandidate> kept_candidates(const PlanningProblem& problem);
  /// For a first plan: rotating in place before driving, driving backward where that is allowed.
  std::vector<BandCandidate> other_starts(const PlanningProblem& problem) const;
  void add_new_bands(Cycle& cycle) const;
  void improve_bands(Cycle& cycle) const;
  /// What the candidate counts with in the choice (3.10).
  double choice_cost(const BandCandidate& candidate, const Cycle& cycle) const;
  void choose(Cycle& cycle) const;
  /// The chosen band may be caught between obstacles that have moved on: what a first call would do competes.
  void try_along_plan(Cycle& cycle) const;
  /// Nothing new is comfortable: what was planned before may still be.
  void try_as_driven(Cycle& cycle) const;
  bool is_comfortable(const BandCandidate& candidate) const;
  /// Drives the chosen band, or evades. The next cycle goes on from an evasive move.
  void command(Cycle& cycle, PlanningResult& result);

  BandPlannerOptions options_;
  std::vector<BandCandidate> bands_;  ///< of the last cycle; the driven one first
  Time planned_at_;
  Time switched_at_;
  Pose2 goal_;
  double acceleration_ = 0.0;  ///< of the last command [m/s^2]
};

}  // namespace bw::teb
