// What a robot records on the route of a building, with the exact truth.
#pragma once

#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "components/lab/bench/buildings/bases.hpp"
#include "components/lab/bench/buildings/building.hpp"
#include "components/lab/bench/buildings/route_follower.hpp"
#include "components/recordings/recorded_drive.hpp"

namespace bw::buildings {

/// Beam i looks at angle_min + i * angle_increment, from the middle of the base.
struct ScannerOptions {
  int beams = 360;
  double angle_min = -std::numbers::pi;               ///< [rad]
  double angle_increment = std::numbers::pi / 180.0;  ///< [rad]
  double range_min = 0.1;                             ///< nearer returns read -inf [m]
  double range_max = 12.0;                            ///< farther ones +inf [m]
  double noise = 0.01;                                ///< standard deviation of a range [m]
  Duration period = Duration::milliseconds(100);      ///< a multiple of kOdometryPeriod
  double time_increment = 0.0;                        ///< from beam to beam [s]; 0: all at the scan's stamp
};

/// 180 beams to the front, 30 m.
ScannerOptions front_scanner();

struct BuildingDriveOptions {
  std::uint64_t seed = 1;  ///< of all noise and of the people, each from a stream of its own
  DrivenBase base = DrivenBase::kobuki;
  std::optional<DriveOptions> wheels;  ///< in place of wheels_of(base)
  int walkers = 0;
  ScannerOptions scanner;
  FollowerOptions follower;
  std::optional<Duration> longest;  ///< the drive ends then; nothing: at the end of the route
};

inline constexpr Duration kOdometryPeriod = Duration::milliseconds(20);

/// Odometry and truth every kOdometryPeriod, both with the same stamps, and scans every period of the
/// scanner, the first at the start; so that there is a sample of either at the stamp of each scan, which is
/// that of its first beam. X_OB starts at zero, truth at the first place of the route, looking along it.
/// The base moves at a constant twist from sample to sample, people in steps of kOdometryPeriod. Odometry and
/// truth do not depend on people and scanner. Same arguments, same bytes.
/// Throws std::invalid_argument when the scanner cannot be: see above, or when its beams take longer than its
/// period; std::runtime_error when the route takes more than a day.
RecordedDrive drive_through(const Building& building, const BuildingDriveOptions& options);

/// The route again and again, in what the building is each time: equal but for what stands in it.
struct Rounds {
  RecordedDrive drive;
  std::vector<Time> begin;  ///< of each round
};
/// The route must end where it starts. Throws as drive_through().
Rounds drive_rounds(std::span<const Building> rounds, const BuildingDriveOptions& options);

}  // namespace bw::buildings
