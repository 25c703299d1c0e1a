// A map from a recorded drive: which topics, through SLAM, onto the disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "components/model/occupancy_grid.hpp"
#include "components/slam/drive_replay.hpp"
#include "runtime/recording/bag/bag.hpp"

namespace bw {

struct MapMakingOptions {
  std::string odometry;            ///< topic; empty: /odom, or the only one of its type
  std::vector<std::string> scans;  ///< likewise, /scan
  slam::SlamOptions slam;
};

/// Loops of the final graph, by what they and the poses differ.
struct LoopResiduals {
  double mean = 0.0;       ///< [m]
  double largest = 0.0;    ///< [m]
  double mean_turn = 0.0;  ///< [rad]
  double largest_turn = 0.0;
};

struct MadeMap {
  OccupancyGrid grid;     ///< its origin is the pose of the first scan
  std::size_t scans = 0;  ///< in the bag
  std::size_t scans_used = 0;
  std::int64_t unmatched = 0;  ///< of these, by odometry alone
  double seconds = 0.0;        ///< from the first scan that was used to the last
  double travel = 0.0;         ///< of the robot, by the map [m]
  std::size_t submaps = 0;
  slam::LoopCounts loops;
  LoopResiduals residuals;
  double free_area = 0.0;             ///< [m^2]
  std::vector<std::string> left_out;  ///< sentences: what was not used, and what to do
  std::string unplaced;               ///< path of the bag whose robot was not found in the map; empty: none
  bool is_whole = true;               ///< false: `progress` ended it
};

struct DriveBag {
  const bag::Bag& recording;
  std::string path;  ///< for messages
};

/// Of bags with scans and odometry, one after the other: in the map of those before, the robot is looked for
/// first. Throws std::runtime_error naming the bag: no scans, no odometry, a topic that is not there or that
/// has to be chosen, with the topics that there are.
MadeMap make_map(const std::vector<DriveBag>& bags, const MapMakingOptions& options,
                 const slam::SlamProgress& progress = {});

/// Sentences for people.
std::string map_report(const MadeMap& map);

}  // namespace bw
