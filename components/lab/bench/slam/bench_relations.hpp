// `bandwagon bench relations`: SLAM on a recorded drive, scored by relations between its poses.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "components/lab/bench/slam/relation_score.hpp"
#include "components/slam/drive_replay.hpp"

namespace bw {

struct BenchRelationsArguments {
  std::string bag;               ///< file or folder; with `columns` a table
  std::string relations;         ///< relations_file.hpp
  std::string columns;           ///< columns file, by which `bag` is imported; empty: it is a bag
  double odometry_scale = 1.0;   ///< handicaps.hpp
  int every = 1;                 ///< of the scans
  std::optional<double> view;    ///< [deg]
  std::vector<std::string> set;  ///< slam_settings.hpp
  std::string json;              ///< output file; empty: none
};

/// Mean and standard deviation [m, deg] that Hess et al. 2016, "Real-time loop closure in 2D LIDAR SLAM",
/// tables II and III, give for Cartographer. Nothing for logs that are not in the project's hands.
struct PublishedErrors {
  double translation = 0.0;
  double translation_deviation = 0.0;
  double rotation = 0.0;
  double rotation_deviation = 0.0;
};
std::optional<PublishedErrors> cartographer_on(std::string_view log);

struct RelationsRun {
  std::string log;                   ///< its name
  std::size_t scans = 0;             ///< of the drive, as it was replayed
  double seconds = 0.0;              ///< from its first scan to its last
  std::size_t relations = 0;         ///< in the file
  slam::RelationErrors at_the_end;   ///< the trajectory after the last optimisation
  slam::RelationErrors of_scans;     ///< the same, of relations between scans that were used alone
  slam::RelationErrors at_the_time;  ///< poses as they were told
  slam::RelationErrors odometry;     ///< of the odometry alone
  slam::LoopCounts loops;
  slam::SlamCounts counts;
  std::size_t submaps = 0;
  double cpu_ms_per_scan = 0.0;  ///< all the work
  double scan_p99_ms = 0.0;      ///< from ranges to pose
  double piece_p99_ms = 0.0;     ///< of the work on loops and the graph
  double piece_max_ms = 0.0;
  std::vector<std::string> left_out;  ///< sentences
};

/// Throws std::runtime_error: unusable files, options, a drive without scans or odometry.
RelationsRun run_relations(const BenchRelationsArguments& arguments);

/// Prints figures, writes JSON. Returns the exit status: 1 where no relation could be used. Throws as
/// run_relations.
int bench_relations(const BenchRelationsArguments& arguments);

}  // namespace bw
