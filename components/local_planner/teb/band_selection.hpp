// Which of several bands is driven (3.10), and which of the others stay for the next cycle.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "components/local_planner/homotopy/homotopy_options.hpp"
#include "components/local_planner/teb/band_candidate.hpp"

namespace bw::teb {

/// The defaults are those of a planner of one band.
struct SelectionOptions {
  double cost_hysteresis = 0.95;           ///< share of its cost that the driven band counts with
  double obstacle_cost_scale = 1.0;        ///< weight of the cost of obstacles in the choice
  double switching_blocking_period = 0.0;  ///< [s] after a switch before the next one
  double max_duration_ratio = std::numeric_limits<double>::infinity();  ///< to the driven one; others go
  std::size_t max_kept = 1;                                             ///< from one cycle to the next
  std::size_t max_spare = 0;                                            ///< beyond those, for their topology
};

/// One place of max_number_classes stays open for a topology that is new, or better by now.
SelectionOptions selection_of(const homotopy::HomotopyOptions& homotopy);

/// Index of the candidate to drive: free ones first, then the cheapest; the driven one as long as it is free
/// when `since_switch` [s] is within the blocking period. At least one candidate.
std::size_t select(const std::vector<BandCandidate>& candidates, const SelectionOptions& options,
                   double since_switch);

/// Marks `chosen` as driven and drops what is not worth another cycle. The driven one is first; empty when no
/// band is usable.
std::vector<BandCandidate> worth_keeping(std::vector<BandCandidate> candidates, std::size_t chosen,
                                         const SelectionOptions& options);

}  // namespace bw::teb
