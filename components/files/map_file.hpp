// Maps on disk as ROS's map_server writes and reads them: a YAML file beside a picture.
#pragma once

#include <filesystem>

#include "components/model/occupancy_grid.hpp"

namespace bw {

/// Keys: image (relative to the YAML), resolution [m], origin [x, y, yaw] of the lower left corner (yaw must
/// be 0), negate, occupied_thresh, free_thresh, mode. With shade s (0 black to 1 white) and p = 1 - s (s if
/// negated): trinary: occupied where p > occupied_thresh, free where p < free_thresh, else unknown; scale:
/// the same, and 1 to 99 in proportion between the thresholds; raw: the pixel's value on the scale 0 to 255
/// is the cell's, unknown above 100. Throws ConfigError (a std::runtime_error) naming file, line, key, value
/// and rule.
OccupancyGrid load_map(const std::filesystem::path& yaml);

/// Writes `yaml` and, beside it, a PGM of the same name; each appears whole or not at all. Cells of 0, 100
/// and unknown are written as trinary; a grid that holds others as raw. load_map() gives back an equal grid.
/// Throws std::runtime_error naming the file that could not be written.
void save_map(const OccupancyGrid& grid, const std::filesystem::path& yaml);

}  // namespace bw
