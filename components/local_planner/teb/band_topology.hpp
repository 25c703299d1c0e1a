// Between bands and the exploration of topologies (homotopy/theory.md 6.2).
#pragma once

#include <vector>

#include "components/local_planner/homotopy/explore.hpp"
#include "components/local_planner/teb/band_candidate.hpp"

namespace bw::teb {

/// Where the band is when.
homotopy::Route route_of(const Band& band);

/// The points of a route as a path to `goal`, for band_along.
std::vector<Pose2> path_of(const homotopy::Route& route, const Pose2& goal);

/// Optimisation may lead several bands into one topology: of those the cheapest free one stays, and counts as
/// driven if one of them was. Bands that are not usable go, unless all are.
void merge_classes(std::vector<BandCandidate>& candidates, const homotopy::Exploration& explored,
                   const homotopy::HomotopyOptions& options);

}  // namespace bw::teb
