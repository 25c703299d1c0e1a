// What the tracker keeps of somebody.
#pragma once

#include <cstdint>
#include <optional>

#include "components/model/time.hpp"
#include "components/people/tracker/heading_filter.hpp"
#include "components/people/tracker/walker.hpp"

namespace bw::people {

struct PersonTrack {
  std::uint32_t id = 0;
  Walker walker;
  std::optional<HeadingFilter> heading;  ///< what is reported in place of the walker, if anything
  Time born;
  Time confirmed;
  Time last_seen;
  double score = 0.5;          ///< smoothed human score of what was seen
  double empty_seconds = 0.0;  ///< for so long the laser saw through where they should be [s]
  int first_unseen = 0;        ///< sweeps since the first leg was seen, or the whole
  int second_unseen = 0;
};

}  // namespace bw::people
