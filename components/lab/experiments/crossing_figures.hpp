// The figures of E5: the source's Figures 3.7 and 3.11. Each a whole <figure>.
#pragma once

#include <string>
#include <vector>

#include "components/lab/experiments/crossing_experiment.hpp"

namespace bw {

/// A planner at two moments.
struct CrossingSnapshots {
  std::string label;
  std::vector<CrossingSnapshot> moments;
};

/// Of planners that compare several bands, one by one: driven once more for the figure.
std::vector<CrossingSnapshots> snapshots_of(const std::vector<CrossingResult>& results,
                                            const CrossingGeometry& geometry, std::uint64_t seed);

/// Bands, the chosen one, and people, at two time stamps.
std::string crossing_snapshot_figure(const std::vector<CrossingSnapshots>& planners,
                                     const std::string& source, std::uint64_t seed);

/// The whole ways of one seed: those of the defaults, and those of the published forms. Every result must hold that
/// run, by its index.
std::string crossing_ways(const std::vector<CrossingResult>& results, const CrossingGeometry& geometry,
                          std::size_t run);

}  // namespace bw
