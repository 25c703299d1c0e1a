// Where new bands of a cycle come from: one along the plan (TEB), or one in each of the best topologies
// (teb_homotopy and what is made of it; homotopy/theory.md 6.2).
#pragma once

#include <functional>
#include <vector>

#include "components/local_planner/homotopy/explore.hpp"
#include "components/local_planner/teb/band_candidate.hpp"

namespace bw::teb {

struct NewBands {
  std::vector<BandCandidate> candidates;  ///< not optimised yet
  /// Called with all candidates of the cycle after their optimisation, which may have led several into one
  /// topology.
  std::function<void(std::vector<BandCandidate>&)> merge;
};

/// `along_plan` is the band along the plan, `kept` those of the last cycle: nobody needs these again. May
/// name them anew.
using BandSource = std::function<NewBands(const PlanningProblem& problem, const Band& along_plan,
                                          std::vector<BandCandidate>& kept)>;

/// The band along the plan, if none is kept.
BandSource one_band();

/// One band in each of the best topologies that no kept band is in; of several that end in one the best
/// stays.
BandSource band_per_topology(const homotopy::HomotopyOptions& homotopy, const BandOptions& band);

}  // namespace bw::teb
