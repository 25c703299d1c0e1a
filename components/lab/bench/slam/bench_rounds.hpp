// `bandwagon bench slam --rounds N`: an office driven through again and again, whose furniture is moved before each
// round. Does the map stay as large as the place, and does what left leave the map?
#pragma once

#include "components/lab/bench/slam/bench_slam.hpp"

namespace bw {

/// What SLAM holds when a round ends, and what the round took.
struct SlamRound {
  std::size_t submaps = 0;  ///< that are there
  std::size_t scans = 0;    ///< whose ranges are there
  std::size_t edges = 0;
  double memory_mb = 0.0;        ///< of these ranges, surfaces and edges
  double cpu_ms_per_scan = 0.0;  ///< of this round, loops included
  std::size_t drawn = 0;         ///< occupied cells of the map
  std::size_t stale = 0;  ///< of these, with nothing within a cell that stood there in this round or the last
  double recall = 0.0;    ///< of what stands there in this round
  double error = 0.0;     ///< of the pose at the end, as it is known then [m]
  double frame = 0.0;     ///< by which the map as a whole is off; the figures of its cells are without it [m]
};

/// Prints a line for each round, and the last beside the third; writes JSON. Returns the exit status (0). One office
/// for each seed; `kinds` is not looked at. Throws ConfigError for `set`.
int bench_rounds(const BenchSlamArguments& arguments);

/// Same arguments, same figures, times apart.
std::vector<SlamRound> drive_slam_rounds(std::uint64_t seed, int rounds,
                                         buildings::BuildingDriveOptions options,
                                         const slam::SlamOptions& slam);

}  // namespace bw
