// Scanners as they are sold, and what they make of the exact distances: noise, steps, beams that are lost,
// and mixed pixels, where a beam meets two things at an edge and tells a position between them.
#pragma once

#include <cstdint>
#include <vector>

#include "components/world/laser_scanner.hpp"

namespace bw::people {

struct ScannerModel {
  LaserOptions laser;              ///< its range_noise is 0: the noise is below
  double noise = 0.02;             ///< standard deviation of a range [m],
  double noise_share = 0.0;        ///< and this share of the range on top
  double cloth = 0.0;              ///< standard deviation on trousers on top [m]
  double mixed = 0.0;              ///< share of the edges at which a beam is mixed
  double lost = 0.0;               ///< share of the beams on trousers without a return
  bool lost_beams_say_so = false;  ///< NaN; else they look like free beams
  double step = 0.0;               ///< ranges are multiples of it [m]; 0: any
};

/// One of those sold, 360 to 1440 beams, 5 to 40 Hz, in some state; or the usual one of simulations: 720
/// beams over 270 degrees, 10 m, noise 0.02 m, nothing else.
ScannerModel draw_scanner(Random& random, bool varied);

/// `exact`: a scan without noise; `on_leg`: a flag for each beam.
LaserScan as_measured(const LaserScan& exact, const std::vector<std::uint8_t>& on_leg,
                      const ScannerModel& model, Random& random);

}  // namespace bw::people
