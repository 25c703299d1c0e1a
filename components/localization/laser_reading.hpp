// One sweep of a laser, and whose it is. Not part of Measurement: it is a view of somebody else's beams, too
// large to keep.
#pragma once

#include "components/model/laser_sweep.hpp"

namespace bw::localization {

/// X_FL: scanner in base_link.
struct LaserReading : LaserSweep {
  int source = 0;
};

}  // namespace bw::localization
