// `bandwagon bench slam --kidnaps N`: a robot that is carried away again and again while SLAM maps. How long it takes to know where it is, and whether it
// says OK while it is somewhere else. The whole component in lock-step, on a log with the exact truth.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/lab/bench/slam/bench_slam.hpp"
#include "components/recordings/recorded_drive.hpp"

namespace bw {

struct KidnapOptions {
  int times = 100;
  double stay = 20.0;            ///< driving on from there [s]
  double least = 5.0;            ///< it is carried at least so far [m]
  std::uint64_t seed = 1;        ///< of the places
  std::vector<std::string> set;  ///< component.parameter=value
};

/// What came of being carried once. Times count from then [s].
struct Kidnap {
  std::optional<double> found_after;  ///< until a pose is told that is right; nothing: not within the stay
  double way = 0.0;                   ///< driven until then, or in all [m]
  double wrong_while_ok = 0.0;        ///< longest time of poses more than 1 m off and of the state OK [s]
};

/// The map is made on the whole drive (a building_drive.hpp: a scan every fifth sample, its truth has headings); then
/// the robot stands for a second, is put to another place of it without odometry's knowing, stands for a second more,
/// and drives on as it did from there. A pose is right within 0.5 m and 10 degrees. Same arguments, same result. Throws ConfigError or std::runtime_error.
std::vector<Kidnap> drive_kidnapped(const RecordedDrive& drive, const KidnapOptions& options);

/// Prints a line for each building; writes JSON. Returns the exit status (0). Throws as drive_kidnapped().
int bench_kidnaps(const BenchSlamArguments& arguments);

}  // namespace bw
