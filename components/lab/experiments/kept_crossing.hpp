// E5's runs of one planner, from the pieces that are kept or driven now.
#pragma once

#include <string>

#include "components/lab/experiments/crossing_experiment.hpp"
#include "components/lab/shards/kept.hpp"

namespace bw {

/// As run_crossing(). `name` is the piece's; `program` tells programs apart. What a result has of an episode
/// is success, collision, time, clearance, index and jerk: times of the planner belong to the machine and are
/// not kept.
CrossingResult kept_crossing(const Kept& kept, const std::string& name, const std::string& program,
                             const CrossingEntry& entry, const CrossingGeometry& geometry, int runs);

}  // namespace bw
