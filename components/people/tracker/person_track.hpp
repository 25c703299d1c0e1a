// What the tracker keeps of somebody.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "components/model/time.hpp"
#include "components/people/tracker/cluster_track.hpp"
#include "components/people/tracker/heading_filter.hpp"
#include "components/people/tracker/walker.hpp"

namespace bw::people {

/// Where somebody was, and how they moved.
struct PastState {
  double time = 0.0;  ///< [s], from the tracker's own origin
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
};

struct PersonTrack {
  std::uint32_t id = 0;
  Walker walker;
  std::optional<HeadingFilter> heading;  ///< what is reported in place of the walker, if anything
  Time born;
  Time confirmed;
  Time last_seen;
  PastState sure;              ///< when they were last seen as a person or a leg plainly is
  PastState settled;           ///< when their legs last went like those of one person
  double score = 0.5;          ///< smoothed human score of what was seen
  double empty_seconds = 0.0;  ///< for so long the laser saw through where they should be [s]
  int first_unseen = 0;        ///< sweeps since the first leg was seen, or the whole
  int second_unseen = 0;
  std::array<std::optional<ClusterTrack>, 2> legs;  ///< what was seen of each lately
};

}  // namespace bw::people
