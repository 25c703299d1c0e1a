// `bandwagon bench slam`: SLAM in simulated buildings, beside the exact truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/lab/bench/buildings/building_drive.hpp"
#include "components/lab/bench/slam/map_score.hpp"
#include "components/lab/bench/slam/truth_score.hpp"

namespace bw {

struct BenchSlamArguments {
  std::vector<buildings::BuildingKind> kinds = {buildings::BuildingKind::office};
  int seeds = 1;
  std::uint64_t first = 1;                ///< of the seeds
  buildings::BuildingDriveOptions drive;  ///< its seed is each of these
  int rounds = 0;                         ///< bench_rounds.hpp in place of it
  int kidnaps = 0;                        ///< bench_kidnaps.hpp in place of it
  bool calibrated = false;                ///< wheels after `bandwagon calibrate`
  std::vector<std::string> set;           ///< slam_settings.hpp
  std::string json;                       ///< output file; empty: none
};

/// Of the i-th seed.
buildings::BuildingDriveOptions drive_options(const BenchSlamArguments& arguments, int i);

/// What came of one drive.
struct SlamDrive {
  std::string building;
  std::size_t scans = 0;
  double way = 0.0;  ///< [m]
  slam::TrajectoryError trajectory;
  slam::MapScore map;           ///< beside the building
  slam::MapScore map_at_truth;  ///< the same scans drawn where they were taken: what a map can be
  slam::LoopFaults loops;
  std::size_t revisits = 0;
  std::size_t missed = 0;
  slam::Consistency consistency;
  double cpu_ms_per_scan = 0.0;  ///< all the work of SLAM
  double scan_p99_ms = 0.0;
  double piece_p99_ms = 0.0;
  double piece_most_ms = 0.0;
  double graph_p99_ms = 0.0;  ///< of work with the whole graph, which the component does beside its scans
  double graph_most_ms = 0.0;
  double online_p99_ms = 0.0;  ///< of a scan as the component handles it: pieces and drawing included
  double online_most_ms = 0.0;
  double memory_mb = 0.0;  ///< most that the process grew by on the drive
};

/// Same arguments, same figures, times apart.
SlamDrive drive_slam(const buildings::Building& building, const buildings::BuildingDriveOptions& options,
                     const slam::SlamOptions& slam);

/// Prints a line for each drive and sums up each kind, writes JSON. Returns the exit status (0). Throws
/// ConfigError for `set`.
int bench_slam(const BenchSlamArguments& arguments);

}  // namespace bw
