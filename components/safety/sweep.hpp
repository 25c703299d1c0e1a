// One sweep of a laser, judged beam by beam before anybody relies on it.
//
// By REP 117 +inf is "nothing up to range_max". Everything else that is no distance within the limits of the
// laser (NaN, -inf, zero, negative, out of bounds) is unknown, and unknown is never free.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "components/model/pose2.hpp"
#include "components/safety/sweep_options.hpp"

namespace bw::safety {

/// As sensor_msgs/LaserScan: beam i looks at angle_min + i * angle_increment in the laser's frame.
struct Sweep {
  double angle_min = 0.0;        ///< [rad]
  double angle_max = 0.0;        ///< [rad], of the last beam
  double angle_increment = 0.0;  ///< [rad]
  double range_min = 0.0;        ///< [m]
  double range_max = 0.0;        ///< [m]
  std::vector<float> ranges;     ///< [m]
};

/// Why a whole sweep cannot be used.
enum class SweepFault {
  none,
  bad_geometry,  ///< angles or range limits that are not finite or make no sense
  wrong_length,  ///< angles and number of ranges disagree, or there are too many
  no_returns,    ///< fewer beams than min_returns hit anything
  mostly_unknown,
};

/// One sentence for people.
std::string_view describe(SweepFault fault);

enum class Beam : std::uint8_t { unknown, clear, hit };

/// Something the laser saw, in base_link.
struct SeenPoint {
  Vector2 position{0.0, 0.0};  ///< [m]
  bool is_narrow = false;      ///< of a thing that stands alone and is no wider than legs
};

struct CheckedSweep {
  SweepFault fault = SweepFault::none;
  double angle_min = 0.0;        ///< of the first beam in base_link [rad]
  double angle_increment = 0.0;  ///< [rad]
  std::vector<Beam> beams;
  std::vector<SeenPoint> points;  ///< hits that enough neighbouring beams confirm
};

/// `X_BS`: pose of the laser in base_link. Beams and points are empty when there is a fault.
CheckedSweep check_sweep(const Sweep& sweep, const Pose2& X_BS, const SweepOptions& options);

/// How much of a sector of directions the laser sees.
struct Sight {
  double covered = 0.0;     ///< share of the sector the laser looks at, 0 to 1
  double unknown = 0.0;     ///< share of the beams there that are unknown, 0 to 1
  double widest_gap = 0.0;  ///< widest run of unknown beams there [rad]
};

/// Sector of `half_angle` [rad] to either side of `bearing` [rad, base_link]. The laser's place on the robot
/// is neglected.
Sight sight_of(const CheckedSweep& sweep, double bearing, double half_angle);

}  // namespace bw::safety
