// What the filter of headings is told of somebody's legs: where the point between them was seen.
#pragma once

#include <optional>

#include "components/people/detection.hpp"
#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/heading_filter.hpp"
#include "components/people/tracker/walker.hpp"

namespace bw::people {

/// Detections that belong to somebody in one sweep; null: that leg was not seen.
struct SeenLegs {
  const Detection* first = nullptr;
  const Detection* second = nullptr;
};

/// The point between the legs. Both seen: half way. One: as far from it as `expected`, the gait before it saw
/// this sweep, says the leg swings, and as unsure as that; not the gait's own point between the legs, whose
/// errors last from sweep to sweep and would be counted again with each.
std::optional<SeenPosition> seen_middle(const SeenLegs& seen, const Walker& expected,
                                        const HeadingOptions& options);

/// The filter of somebody new: from the first two common sightings of two legs and what followed; of a single
/// leg, or when both were seen together but once, from the gait.
HeadingFilter heading_of(const ClusterTrack& first, const ClusterTrack* second, const Walker& walker,
                         const HeadingOptions& options);

}  // namespace bw::people
