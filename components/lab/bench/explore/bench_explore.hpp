// `bandwagon bench explore`: buildings explored by a whole robot, beside a tour that knows them.
#pragma once

#include <string>
#include <vector>

#include "components/lab/bench/buildings/building.hpp"
#include "components/lab/bench/explore/explore_drive.hpp"

namespace bw {

struct BenchExploreArguments {
  std::vector<buildings::BuildingKind> kinds = {buildings::BuildingKind::office};
  std::string map;  ///< map_server's file of a place that is explored instead; empty: none
  std::vector<double> start = {0.0, 0.0};  ///< x, y in it [m]
  int seeds = 1;                           ///< of each kind; with a map so many drives, whose noise differs
  std::uint64_t first = 1;                 ///< of the seeds
  bool ideal = false;                      ///< without errors and without DDS: ideal_exploration.hpp
  ExploreDriveOptions drive;               ///< its seed is each of these
  std::string maps;                        ///< folder for the map of each drive; empty: none
  std::string json;                        ///< output file; empty: none
};

/// Prints a line for each drive and sums up each kind; writes JSON and maps. Returns the exit status (0). Throws
/// ConfigError or std::runtime_error.
int bench_explore(const BenchExploreArguments& arguments);

}  // namespace bw
