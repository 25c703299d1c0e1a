// The few beams of a sweep that a pose is compared by, as end points.
#pragma once

#include <cstddef>
#include <vector>

#include "components/model/laser_sweep.hpp"

namespace bw::localization {

/// End points of beams, and where they come from, in base_link [m].
struct BeamEnds {
  std::vector<float> x;
  std::vector<float> y;
  Vector2 scanner{0.0, 0.0};

  std::size_t size() const { return x.size(); }
};

/// `sweep` without fault. At most one beam out of each of `max_beams` equal parts of the sweep: the one
/// nearest the part's middle that hit something, the scanner in base_link. Others give no end: where a beam
/// did not end says little, and the map may lack what it should have met. Nor does a hit at range_max, by
/// which some drivers say no return.
BeamEnds beam_ends(const LaserSweep& sweep, int max_beams);

}  // namespace bw::localization
