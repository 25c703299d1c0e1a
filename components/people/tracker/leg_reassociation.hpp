// Whose leg is whose. Assignment goes sweep by sweep and can hand a leg of one to another while legs touch or
// hide each other, or take a leg of a chair; a few sweeps later the way the legs went tells: those of one
// person stay close, and their middle goes straight.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

/// How little two legs look like those of one person by their last common sightings [m]; nothing when too few
/// show both.
std::optional<double> doubt_of_legs(const ClusterTrack& a, const ClusterTrack& b,
                                    const LegReassociationOptions& options);

/// Legs paired anew.
struct ReassociatedLegs {
  std::vector<std::array<ClusterTrack, 2>> legs;  ///< of each of the people
  std::vector<ClusterTrack> left;                 ///< legs that were theirs and are nobody's now
  std::vector<int> taken;                         ///< indices of clusters that are legs of theirs now
};

/// Pairs anew the legs of somebody, or of two, and clusters near them that look like legs, if what they did
/// lately says so with a margin. Only what was seen in sweep number `sweep` counts.
std::optional<ReassociatedLegs> reassociate_legs(const std::vector<const PersonTrack*>& people,
                                                 const std::vector<ClusterTrack>& clusters,
                                                 std::int64_t sweep, const LegReassociationOptions& options);

}  // namespace bw::people
