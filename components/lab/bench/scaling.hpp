// How planning scales with what is around the path: times, costs with and without limits, and drives.
#pragma once

#include <string>
#include <vector>

#include "components/lab/bench/scaling_scenes.hpp"

namespace bw {

/// Of one planner and one number of obstacles. Times are medians of process CPU ms, costs means over the
/// scenes.
struct ScalingRow {
  int count = 0;
  double field_ms = 0.0;             ///< obstacles made ready for bands, once a cycle
  double cold_band_ms = 0.0;         ///< one band along the plan, optimised for the first time
  double warm_band_ms = 0.0;         ///< and once more
  double cold_cycle_ms = 0.0;        ///< the whole first call of the planner
  double warm_cycle_ms = 0.0;        ///< the calls after it
  double cost = 0.0;                 ///< of the band that is driven in the end
  double cost_without_limits = 0.0;  ///< the same with room for 100 obstacles at each pose
  double left_out = 0.0;             ///< obstacles_left_out of the last cycle
};

/// Every repetition, a scene of its own, goes through all numbers in turn, so that ratios between rows are
/// paired.
std::vector<ScalingRow> measure_scaling(Crowding crowding, const std::vector<int>& counts,
                                        const std::string& planner, int repetitions);

/// Drives to the goal by an ideal base, as long as `timeout` [s].
struct ScalingDrives {
  int count = 0;
  int drives = 0;
  int arrived = 0;         ///< without contact
  double mean_time = 0.0;  ///< [s] of all; a drive that does not arrive takes the timeout
  double slowest = 0.0;    ///< largest ratio of a drive's time to that of the same drive in the first row
};

/// Through the corridor of points, scenes of seeds 1 to `drives`.
std::vector<ScalingDrives> drive_corridors(const std::vector<int>& counts, const std::string& planner,
                                           int drives);

struct BenchScalingArguments {
  std::vector<std::string> planners = {"teb", "teb_homotopy", "eteb"};
  int repetitions = 20;
  int drives = 50;
  std::string json;  ///< output file; empty: none
};

/// Prints tables to stdout, writes JSON. Returns the exit status (0). Throws std::runtime_error on unusable
/// names.
int bench_scaling(const BenchScalingArguments& arguments);

}  // namespace bw
