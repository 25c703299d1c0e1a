// Options of SLAM offline, as `--set` gives them.
#pragma once

#include <string>
#include <vector>

#include "components/slam/slam_options.hpp"

namespace bw::slam {

/// Defaults changed by each `slam.resolution=0.1`; `slam.` may be left out. Throws ConfigError naming an
/// option that is not there, and the nearest known one, or a value out of its range.
SlamOptions slam_options_of(const std::vector<std::string>& settings);

}  // namespace bw::slam
