#include "components/local_planner/teb/band_source.hpp"

#include <utility>

#include "components/local_planner/teb/band_topology.hpp"

namespace bw::teb {

BandSource one_band() {
  return [](const PlanningProblem&, const Band& along_plan, std::vector<BandCandidate>& kept) {
    NewBands found{.candidates = {}, .merge = [](std::vector<BandCandidate>&) {}};
    if (kept.empty()) found.candidates.push_back({.band = along_plan, .label = "plan"});
    return found;
  };
}

BandSource band_per_topology(const homotopy::HomotopyOptions& homotopy, const BandOptions& band) {
  return [=](const PlanningProblem& problem, const Band& along_plan, std::vector<BandCandidate>& kept) {
    std::vector<homotopy::Route> in_use;
    for (const BandCandidate& candidate : kept) in_use.push_back(route_of(candidate.band));
    homotopy::Exploration explored = homotopy::explore(problem, band.min_obstacle_dist, in_use, homotopy);
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i].label = explored.in_use_labels[i];
    NewBands found;
    for (const homotopy::Path& path : explored.paths) {
      found.candidates.push_back({.band = path.is_plan ? along_plan
                                                       : band_along(path_of(path.route, problem.plan.back()),
                                                                    problem.pose, problem.limits, band),
                                  .label = path.label});
    }
    found.merge = [homotopy, explored = std::move(explored)](std::vector<BandCandidate>& candidates) {
      merge_classes(candidates, explored, homotopy);
    };
    return found;
  };
}

}  // namespace bw::teb
