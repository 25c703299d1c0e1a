// Local planners on timed elastic bands, kept from cycle to cycle (book 6.1 to 6.7): `teb` on one band,
// `teb_homotopy`, `pteb` and `eteb` on one band in each of the best topologies.
#pragma once

#include <optional>
#include <vector>

#include "components/local_planner/driving.hpp"
#include "components/local_planner/homotopy/explore.hpp"
#include "components/local_planner/teb/band_candidate.hpp"
#include "components/local_planner/teb/hrvo_preference.hpp"
#include "components/local_planner/teb/prediction_options.hpp"
#include "components/local_planner/teb/teb_options.hpp"
#include "components/model/planning.hpp"

namespace bw::teb {

/// What makes one of these planners of the band.
struct BandPlannerOptions {
  DrivingOptions driving;
  TebOptions teb;
  PredictionOptions prediction;
  std::optional<homotopy::HomotopyOptions> homotopy;  ///< without: one band
  std::optional<HrvoPreferenceOptions> hrvo;          ///< with: selection by (3.12)
};

/// Each call: cut the bands of the last cycle to where the robot is, add new ones along the plan and in
/// topologies not held yet, optimise them among the obstacles, and drive the cheapest whose footprint is free
/// for the next feasibility_check_time; the command is the velocity its start asks for after command_lead. If
/// that is an old band and not free, or a long detour, a new band along the plan competes. If none is free:
/// an evasive move, then a stop (status infeasible).
class BandPlanner final : public LocalPlanner {
 public:
  explicit BandPlanner(BandPlannerOptions options) : options_(std::move(options)) {}

  PlanningResult plan(const PlanningProblem& problem) override;
  void reset() override;

 private:
  std::vector<BandCandidate> kept_candidates(const PlanningProblem& problem);
  /// For a first plan: turning on the spot before driving, driving backward where that is allowed.
  void add_other_starts(const PlanningProblem& problem, std::vector<BandCandidate>& candidates) const;
  /// Adds bands in topologies that no candidate has; says how topologies are told apart in this cycle.
  std::optional<homotopy::Exploration> add_new(const PlanningProblem& problem, const Band& along_plan,
                                               std::vector<BandCandidate>& candidates) const;
  /// Index of the candidate to drive: free ones first, then the cheapest. At least one candidate.
  std::size_t select(const std::vector<BandCandidate>& candidates) const;
  void keep(std::vector<BandCandidate> candidates, std::size_t chosen);

  BandPlannerOptions options_;
  std::vector<BandCandidate> bands_;  ///< of the last cycle; the driven one first
  Time planned_at_;
  Time switched_at_;
  Pose2 goal_;
  double acceleration_ = 0.0;  ///< of the last command [m/s^2]
  bool arrived_ = false;
};

}  // namespace bw::teb
