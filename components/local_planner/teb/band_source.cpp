#include "components/local_planner/teb/band_source.hpp"

#include <algorithm>
#include <iterator>
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

namespace {

std::vector<BandCandidate> take_spares(std::vector<BandCandidate>& kept) {
  const auto is_kept = [](const BandCandidate& c) { return !c.spare; };
  const auto first = std::stable_partition(kept.begin(), kept.end(), is_kept);
  std::vector<BandCandidate> spares(std::make_move_iterator(first), std::make_move_iterator(kept.end()));
  kept.erase(first, kept.end());
  return spares;
}

}  // namespace

BandSource band_per_topology(const homotopy::HomotopyOptions& homotopy, const BandOptions& band) {
  return [=](const PlanningProblem& problem, const Band& along_plan, std::vector<BandCandidate>& kept) {
    std::vector<BandCandidate> spares = take_spares(kept);
    std::vector<homotopy::Route> in_use;
    for (const BandCandidate& candidate : kept) in_use.push_back(route_of(candidate.band));
    homotopy::Exploration explored = homotopy::explore(problem, band.min_obstacle_dist, in_use, homotopy);
    for (std::size_t i = 0; i < kept.size(); ++i) kept[i].label = explored.in_use_labels[i];
    NewBands found;
    const auto is_in = [&](const BandCandidate& spare, const homotopy::Path& path) {
      const homotopy::Signature signature =
          homotopy::signature_of(route_of(spare.band), explored.bodies, explored.course, homotopy);
      return homotopy::same_class(signature, path.signature, homotopy);
    };
    for (const homotopy::Path& path : explored.paths) {
      const auto spare = std::ranges::find_if(
          spares, [&](const BandCandidate& c) { return !path.is_plan && is_in(c, path); });
      if (spare != spares.end()) {
        found.candidates.push_back(std::move(*spare));
        found.candidates.back().spare = false;
        found.candidates.back().label = path.label;
        spares.erase(spare);
        continue;
      }
      found.candidates.push_back({.band = path.is_plan ? along_plan
                                                       : band_along(path_of(path.route, problem.plan.back()),
                                                                    problem.pose, problem.limits, band),
                                  .label = path.label,
                                  .along_plan = path.is_plan});
    }
    found.merge = [homotopy, explored = std::move(explored)](std::vector<BandCandidate>& candidates) {
      merge_classes(candidates, explored, homotopy);
    };
    return found;
  };
}

}  // namespace bw::teb
