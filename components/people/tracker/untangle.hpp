// Whose leg is whose where people pass close to each other. Assignment goes sweep by sweep and can hand a leg
// of one to another while legs touch or hide each other; a few sweeps later the way the legs went tells:
// those of one person stay close, and their middle goes straight.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "components/people/tracker/birth.hpp"
#include "components/people/tracker/person_track.hpp"
#include "components/people/tracker/tracker_options.hpp"

namespace bw::people {

using LegPair = std::array<const ClusterTrack*, 2>;

/// How little two legs look like those of one person by their last common sweeps [m]; nothing when too few
/// show both.
std::optional<double> doubt_of_legs(const ClusterTrack& a, const ClusterTrack& b,
                                    const UntangleOptions& options);

/// Pairs the legs of somebody, or of two, and legs near them that are nobody's, anew, if what they did lately
/// says so with a margin: one pair for each of `people`, empty if nothing is better. Legs seen in sweep
/// number `sweep` count.
std::vector<LegPair> better_pairs(const std::vector<const PersonTrack*>& people,
                                  const std::vector<const ClusterTrack*>& strangers, std::int64_t sweep,
                                  const UntangleOptions& options);

}  // namespace bw::people
