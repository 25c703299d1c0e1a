#include "components/local_planner/teb/band_selection.hpp"

#include <algorithm>
#include <tuple>

namespace bw::teb {
namespace {

constexpr double kMaxDuration = 3.0;  // of a kept band, to the driven one

}  // namespace

SelectionOptions selection_of(const homotopy::HomotopyOptions& homotopy) {
  return {.cost_hysteresis = homotopy.selection_cost_hysteresis,
          .obstacle_cost_scale = homotopy.selection_obst_cost_scale,
          .switching_blocking_period = homotopy.switching_blocking_period,
          .max_duration_ratio = kMaxDuration,
          .max_kept = static_cast<std::size_t>(std::max(homotopy.max_number_classes - 1, 1)),
          .max_spare = homotopy.max_number_classes > 1 ? 1u : 0u};
}

std::size_t select(const std::vector<BandCandidate>& candidates, const SelectionOptions& options,
                   double since_switch) {
  if (since_switch < options.switching_blocking_period) {
    const auto driven = std::find_if(candidates.begin(), candidates.end(),
                                     [](const BandCandidate& c) { return c.driven && c.safety.free; });
    if (driven != candidates.end()) return static_cast<std::size_t>(driven - candidates.begin());
  }
  const auto rank = [&](const BandCandidate& c) {
    const double cost = c.driven && c.settled ? options.cost_hysteresis * c.cost : c.cost;
    return std::tuple(!c.safety.free, !c.report.usable, !c.report.finished, cost);
  };
  const auto better = [&](const BandCandidate& l, const BandCandidate& r) { return rank(l) < rank(r); };
  return static_cast<std::size_t>(std::min_element(candidates.begin(), candidates.end(), better) -
                                  candidates.begin());
}

std::vector<BandCandidate> worth_keeping(std::vector<BandCandidate> candidates, std::size_t chosen,
                                         const SelectionOptions& options) {
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].driven = i == chosen;
  candidates[chosen].settled = candidates[chosen].kept;
  std::erase_if(candidates, [](const BandCandidate& c) { return !c.report.usable; });
  if (candidates.empty()) return candidates;
  std::stable_sort(candidates.begin(), candidates.end(), [](const BandCandidate& l, const BandCandidate& r) {
    return std::tuple(!l.driven, !l.safety.free, l.cost) < std::tuple(!r.driven, !r.safety.free, r.cost);
  });
  const double longest = options.max_duration_ratio * candidates.front().band.duration();
  std::erase_if(candidates, [&](const BandCandidate& c) { return !c.driven && c.band.duration() > longest; });
  if (candidates.size() > options.max_kept + options.max_spare)
    candidates.resize(options.max_kept + options.max_spare);
  for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].spare = i >= options.max_kept;
  // Where it is not free a new plan is the better start.
  std::erase_if(candidates, [](const BandCandidate& c) { return c.spare && !c.safety.free; });
  return candidates;
}

}  // namespace bw::teb
