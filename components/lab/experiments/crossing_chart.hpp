// The figures of E5: the source's Figures 3.7 and 3.11.
#pragma once

#include <string>
#include <vector>

#include "components/lab/experiments/crossing_experiment.hpp"
#include "components/lab/report/document.hpp"

namespace bw {

/// Of planners that compare several bands, one by one, driven once more: bands, the chosen one, and people,
/// at two time stamps.
report::Figure crossing_snapshots_figure(const std::vector<CrossingResult>& results,
                                         const CrossingGeometry& geometry, const std::string& source,
                                         std::uint64_t seed);

/// The whole paths of one seed: those of the defaults, and those of the published forms. Every result must
/// hold that run, by its index.
report::Figure crossing_paths_figure(const std::vector<CrossingResult>& results,
                                     const CrossingGeometry& geometry, std::size_t run);

}  // namespace bw
