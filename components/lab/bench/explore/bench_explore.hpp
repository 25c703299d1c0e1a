// `bandwagon bench explore`: exploring in simulated buildings with SLAM and the global planner, beside the nearest
// frontier alone and beside a tour that knows the building.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "components/explore/explorer.hpp"
#include "components/lab/bench/buildings/building.hpp"

namespace bw {

struct BenchExploreArguments {
  std::vector<buildings::BuildingKind> kinds = {buildings::BuildingKind::office};
  int seeds = 1;
  std::uint64_t first = 1;  ///< of the seeds
  std::string json;         ///< output file; empty: none
};

/// What came of one building. A robot that the global planner leads, its base without delay and slip, its odometry
/// 0.3 % off; nobody else is there.
struct Exploration {
  bool is_complete = false;  ///< within two hours
  double known =
      0.0;  ///< share of the cells that the footprint can reach which the map has as free, at the end
  double length = 0.0;     ///< [m] until nothing was left, without the way back
  double length_98 = 0.0;  ///< [m] until 98 % were known; 0: never
  std::size_t goals = 0;
  std::size_t failed = 0;    ///< of these
  std::size_t given_up = 0;  ///< frontiers
  int contacts = 0;          ///< times that the footprint came into a wall
};
Exploration explore_building(const buildings::Building& building, std::uint64_t seed,
                             const explore::ExplorerOptions& options);

/// Path [m] of a robot that knows the building and drives to the nearest cell that it has not seen, until 98 % are
/// seen.
double tour_length(const buildings::Building& building);

/// Prints a line for each building and sums up each kind; writes JSON. Returns the exit status (0).
int bench_explore(const BenchExploreArguments& arguments);

}  // namespace bw
