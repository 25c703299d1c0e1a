// The dynamic window approach as DWB's users know it (theory.md 5.9): samples are judged by the plan, the
// real footprint, and in EDWA by HRVO while people matter.
#pragma once

#include <optional>
#include <vector>

#include "components/local_planner/checked_planner.hpp"
#include "components/local_planner/dwa/critics.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/hrvo_guide.hpp"
#include "components/local_planner/dwa/rotate_to_plan.hpp"
#include "components/local_planner/dwa/stuck_recovery.hpp"
#include "components/local_planner/hrvo/hrvo_options.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// Each call: the velocities in reach, of those the ones that can brake before the footprint touches
/// anything, of those the cheapest (critics.hpp) from which it can brake clear of where people will be. Where
/// the plan leads off by more than kRotateThreshold: a rotation in place. If none is admissible: as every
/// planner, an evasive move or a stop, status infeasible; a robot that stands long backs off. Remembers which
/// way it turns and how long it stands.
class CriticsPlanner final : public CheckedPlanner {
 public:
  /// With options of EDWA it is EDWA.
  CriticsPlanner(const DwaOptions& options, const DrivingOptions& driving)
      : CriticsPlanner(options, driving, {}, {}) {}
  CriticsPlanner(const DwaOptions& options, const DrivingOptions& driving, std::optional<EdwaOptions> edwa,
                 const hrvo::HrvoOptions& hrvo)
      : CheckedPlanner(driving), options_(options), edwa_(edwa), hrvo_(hrvo) {}

 private:
  struct Judged {
    RollOut roll_out;
    double cost = 0.0;
  };

  PlanningResult drive(const PlanningProblem& problem) override;
  void forget() override;
  void remember(const CheckedPlanner& earlier) override;

  std::optional<HrvoGuide> guide_of(const PlanningProblem& problem) const;
  std::vector<Judged> judged(const PlanningProblem& problem, const PlanningProblem& walkers,
                             const Course& course, RollOuts& roll_outs, const std::optional<HrvoGuide>& guide,
                             std::optional<double> rotation) const;
  void choose(const std::vector<Judged>& judged, const RollOuts& roll_outs, const PlanningProblem& walkers,
              PlanningResult& result) const;
  double comfort_among_walkers(const PlanningProblem& walkers, const RollOuts& roll_outs,
                               const Twist2& held) const;
  bool can_stop_among(const PlanningProblem& walkers, const Twist2& twist) const;

  DwaOptions options_;
  std::optional<EdwaOptions> edwa_;
  hrvo::HrvoOptions hrvo_;
  RotateToPlan rotate_to_plan_;
  StuckRecovery recovery_;
};

}  // namespace bw::dwa
