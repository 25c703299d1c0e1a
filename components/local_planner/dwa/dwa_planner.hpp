// Local planners `dwa` (Fox, Burgard, Thrun 1997; spec 5.2) and `edwa`, the same with the heading and speed
// that HRVO advises (spec 5.4).
#pragma once

#include <optional>

#include "components/local_planner/dwa/arc.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/sample_score.hpp"
#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// Each call: the velocities in reach (V_s and V_d), of those the ones that can brake before the first
/// contact on their arc (V_a), of those the one with the largest G = alpha head + beta dist + gamma vel
/// (3.1). Obstacles stand still where they are now. The footprint counts as a disc. If none is admissible:
/// an evasive move, if one is asked for and clear; else braking with no turn, status infeasible. Keeps
/// from call to call only that it has arrived.
class DwaPlanner final : public LocalPlanner {
 public:
  explicit DwaPlanner(const DwaOptions& options) : options_(options) {}
  DwaPlanner(const DwaOptions& options, const EdwaOptions& edwa, const hrvo::HrvoOptions& hrvo)
      : options_(options), edwa_({edwa, hrvo}) {}

  PlanningResult plan(const PlanningProblem& problem) override;
  void reset() override { arrived_ = false; }

 private:
  struct Edwa {
    EdwaOptions options;
    hrvo::HrvoOptions hrvo;
  };
  // An admissible velocity and the time it is rolled out.
  struct Sample {
    Arc arc;
    double horizon = 0.0;
    double gap = 0.0;  // [m] from 0 to the cap
  };

  std::vector<Sample> admissible(const PlanningProblem& problem, const Vector2& aim) const;
  ScoreColumns score(const std::vector<Sample>& samples, const PlanningProblem& problem, const Vector2& aim,
                     const std::optional<hrvo::Advice>& advice) const;
  void show(const std::vector<Sample>& samples, const std::vector<double>& scores,
            PlanningResult& result) const;
  PlanningResult arrive(const PlanningProblem& problem) const;
  void evade(const PlanningProblem& problem, PlanningResult& result) const;

  DwaOptions options_;
  std::optional<Edwa> edwa_;
  bool arrived_ = false;
};

}  // namespace bw::dwa
