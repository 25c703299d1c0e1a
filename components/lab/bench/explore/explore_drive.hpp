// One building explored by a whole robot in lock-step: emulated base and laser, SLAM, planners, and `explore`.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "components/lab/bench/buildings/building.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw {

struct ExploreDriveOptions {
  std::uint64_t seed = 1;  ///< of all noise
  std::string graph = "map_drive";
  std::string robot = "kobuki";  ///< file or name of config/robots
  double longest = 3600.0;       ///< [s]
  std::vector<std::string> set;  ///< component.parameter=value
};

struct ExploreDrive {
  std::string status;     ///< the last that `explore/status` said
  bool complete = false;  ///< by what it says
  double time = 0.0;      ///< until then [s]
  double travel = 0.0;    ///< that was driven until then, by the truth [m]
  std::uint32_t contacts = 0;
  double radius = 0.0;               ///< of the robot [m]
  std::optional<OccupancyGrid> map;  ///< at the end
  std::string samples_sha256;
};

/// Without a way back at the end. It starts at the first place of the building's route; map and building have one frame. Throws ConfigError or
/// std::runtime_error.
ExploreDrive explore_building(const buildings::Building& building, const ExploreDriveOptions& options);

}  // namespace bw
