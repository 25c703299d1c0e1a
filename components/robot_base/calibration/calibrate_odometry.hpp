// Wheel radius, ratio of the radii and wheel separation from motions with measured ends.
//
// The experiment is UMBmark (Borenstein and Feng 1996): squares in both directions tell an error of the
// separation, which adds to each rotation of one and takes from each of the other, from unequal wheels, which
// bend all legs to the same side; a straight path of known length tells the scale, which no closed path does.
// Their formulas for E_d and E_b hold for small errors. Here the rotations of the wheels are rolled off again
// with other sizes until they end where the robot ended:
//
//   minimise  sum over motions  r' C^-1 r + prior     r = rolled(rotations, geometry) - moved
//
// over the logarithms of (radius, ratio, separation), C by the wheel noise of model/README.md 2.2 and the
// errors of measuring; Gauss-Newton. It is exact for errors of any size, and weighs a heading or a corner
// that was measured too for what it tells.
#pragma once

#include <optional>
#include <vector>

#include "components/robot_base/calibration/measured_motion.hpp"

namespace bw {

struct MeasuringErrors {
  double position = 0.005;  ///< sd of each end, x and y [m]
  double heading = 0.01;    ///< sd of each end [rad]
  /// k of model/README.md 2.2 [m]: how motions are weighed against each other
  double variance_per_metre = 1e-5;
};

struct Calibration {
  WheelGeometry geometry;
  WheelGeometry
      share_of_error;         ///< standard errors, as shares of the values, from how well the motions agree
  double disagreement = 0.0;  ///< root mean square of what remains, in standard deviations that were expected
};

/// `start`: what the robot file says. Nothing when there are no motions, or they do not tell what was asked:
/// a separation without rotations.
std::optional<Calibration> calibrate_odometry(const std::vector<MeasuredMotion>& motions,
                                              const WheelGeometry& start, const MeasuringErrors& errors);

}  // namespace bw
