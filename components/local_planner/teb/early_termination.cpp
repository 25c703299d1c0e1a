#include "components/local_planner/teb/early_termination.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

namespace bw::teb {
namespace {

// Share of the best cost so far below which the outlook of a first plan must lie for it to be finished in
// this cycle.
// Of the others those that matter go on in the next one.
constexpr double kWorthFinishing = 0.85;

class EarlyTermination {
 public:
  EarlyTermination(std::vector<BandCandidate>& candidates, const PlanningProblem& problem,
                   const ObstacleField& field, const BandOptions& options, const DrivingOptions& driving,
                   const EarlyTerminationOptions& termination, int max_iterations)
      : candidates_(candidates),
        problem_(problem),
        field_(field),
        options_(options),
        driving_(driving),
        termination_(termination),
        max_iterations_(max_iterations),
        share_(std::max(1, max_iterations / static_cast<int>(candidates.size()))) {}

  void run() {
    const auto is_driven = [](const BandCandidate& c) { return c.driven; };
    const auto driven = std::ranges::find_if(candidates_, is_driven);
    if (termination_.terminates_losers && driven != candidates_.end()) {
      work(*driven, {});
      compare_with(*driven);
    }
    for_each([&](BandCandidate& c) {
      if (!termination_.terminates_losers) {
        work(c, {});
      } else if (!c.driven) {
        work(c, c.kept ? Effort{.rival = rival_} : Effort{.last_round = 1});
      }
    });
    if (termination_.terminates_losers) finish_plans();
  }

 private:
  void for_each(const std::function<void(BandCandidate&)>& body) {
    const auto at = [&](std::size_t i) { body(candidates_[i]); };
    if (problem_.parallel_for) {
      problem_.parallel_for(candidates_.size(), at);
    } else {
      for (std::size_t i = 0; i < candidates_.size(); ++i) at(i);
    }
  }

  // What a band may come to when its first plan is finished: limits and kinematics still cost much after the
  // first solve, and little in the end; its time stays about the same, and obstacles go only for a longer
  // way.
  double outlook(const BandCandidate& c) const {
    return options_.weights.time * options_.dt_ref * c.band.duration() + c.report.obstacle_cost;
  }

  // The one along the plan first, then the most promising: with what it comes to the others are compared.
  void finish_plans() {
    std::vector<BandCandidate*> open;
    for (BandCandidate& c : candidates_) {
      if (c.kept) {
        compare_with(c);
      } else if (c.report.usable && options_.no_outer_iterations > 1) {
        open.push_back(&c);
      }
    }
    std::ranges::stable_sort(
        open, {}, [this](const BandCandidate* c) { return std::pair(!c->along_plan, outlook(*c)); });
    for (BandCandidate* c : open) {
      if (outlook(*c) >= kWorthFinishing * rival_) break;
      work(*c, {.first_round = 1, .rival = rival_});
      compare_with(*c);
    }
  }

  void compare_with(const BandCandidate& c) {
    if (!c.report.usable || !c.report.finished || !c.safety.free || c.safety.comfort < driving_.mover_margin)
      return;
    const bool has_advantage = c.driven && c.settled;
    rival_ = std::min(rival_, has_advantage ? termination_.cost_hysteresis * c.cost : c.cost);
  }

  // Within what is left of its share.
  void work(BandCandidate& c, Effort effort) const {
    const int first = static_cast<int>(&c - candidates_.data()) * share_;
    const int spent = c.report.iterations;
    effort.max_iterations = std::min(share_, std::max(0, max_iterations_ - first)) - spent;
    if (effort.first_round > 0 && effort.max_iterations <= 0) return;
    improve(c, problem_, field_, options_, driving_, effort);
    c.report.iterations += spent;
  }

  std::vector<BandCandidate>& candidates_;
  const PlanningProblem& problem_;
  const ObstacleField& field_;
  const BandOptions& options_;
  const DrivingOptions& driving_;
  EarlyTerminationOptions termination_;
  int max_iterations_;
  int share_;
  double rival_ = std::numeric_limits<double>::infinity();
};

}  // namespace

int improve_all(std::vector<BandCandidate>& candidates, const PlanningProblem& problem,
                const ObstacleField& field, const BandOptions& options, const DrivingOptions& driving,
                const EarlyTerminationOptions& termination, int max_iterations) {
  if (candidates.empty()) return 0;
  EarlyTermination(candidates, problem, field, options, driving, termination, max_iterations).run();
  int spent = 0;
  for (const BandCandidate& candidate : candidates) spent += candidate.report.iterations;
  return spent;
}

}  // namespace bw::teb
