// Local planners `dwa` (Fox, Burgard, Thrun 1997; book 5.2) and `edwa`, the same with the heading and speed
// that HRVO advises (book 5.4).
#pragma once

#include <optional>

#include "components/local_planner/driving.hpp"
#include "components/local_planner/dwa/admissible_samples.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/dwa/sample_score.hpp"
#include "components/local_planner/hrvo/hrvo.hpp"
#include "components/model/planning.hpp"

namespace bw::dwa {

/// Each call: the velocities in reach, of those the ones that can brake before the first contact on their
/// arc, of those the one with the largest G = alpha head + beta dist + gamma vel (3.1), and, by
/// option, from which it can brake clear of where people will be. The footprint counts as a disc. If none is
/// admissible: an evasive move, if one is asked for and clear; else braking with no turn, status infeasible.
/// Keeps from call to call only that it has arrived.
class DwaPlanner final : public LocalPlanner {
 public:
  DwaPlanner(const DwaOptions& options, const DrivingOptions& driving)
      : options_(options), driving_(driving) {}
  DwaPlanner(const DwaOptions& options, const DrivingOptions& driving, const EdwaOptions& edwa,
             const hrvo::HrvoOptions& hrvo)
      : options_(options), driving_(driving), edwa_({edwa, hrvo}) {}

  PlanningResult plan(const PlanningProblem& problem) override;
  void reset() override { arrived_ = false; }

 private:
  struct Edwa {
    EdwaOptions options;
    hrvo::HrvoOptions hrvo;
  };

  ScoreColumns columns_of(const std::vector<Sample>& samples, const PlanningProblem& problem,
                          const Vector2& aim, const std::optional<hrvo::Advice>& advice) const;
  void choose(const std::vector<Sample>& samples, const std::vector<double>& scores,
              const PlanningProblem& problem, PlanningResult& result) const;
  bool can_stop_among_movers(const Sample& sample, const PlanningProblem& problem) const;

  DwaOptions options_;
  DrivingOptions driving_;
  std::optional<Edwa> edwa_;
  bool arrived_ = false;
};

}  // namespace bw::dwa
