// Maps on disk as ROS's map_server writes and reads them: a YAML file beside a picture.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "components/files/map_shades.hpp"
#include "components/model/occupancy_grid.hpp"
#include "runtime/base/choice.hpp"

namespace bw {

/// Keys: image (relative to the YAML), resolution [m], origin [x, y, yaw] of the lower left corner (yaw must
/// be 0), negate, occupied_thresh, free_thresh, mode; what shades mean: map_shades.hpp. Throws ConfigError (a
/// std::runtime_error) naming file, line, key, value and rule.
OccupancyGrid load_map(const std::filesystem::path& yaml);

/// What is wrong with a map, in the terms of nav2_msgs/LoadMap.
enum class MapFault { none, no_file, bad_metadata, bad_data, other };

struct MapReading {
  MapFault fault = MapFault::other;
  std::string reason;  ///< why there is no grid
  OccupancyGrid grid;
};

/// load_map() for files that somebody names while the robot drives: never throws.
MapReading try_load_map(const std::filesystem::path& yaml);

enum class ImageFormat { pgm, png };
constexpr auto choice_table(ImageFormat) {
  return choices<ImageFormat>({{ImageFormat::pgm, "pgm"}, {ImageFormat::png, "png"}});
}

/// The file below `folder` that a request names: relative to it, or absolute and within it; `.yaml` is added
/// where it is missing. Throws std::runtime_error: a folder or subfolder that is not there, a way out of it
/// (`..`, another absolute path, a link to elsewhere).
std::filesystem::path path_of_map(const std::filesystem::path& folder, const std::filesystem::path& asked);

enum class Existing { refuse, replace };

/// Writes `yaml` and, beside it, a picture of the same name; each appears whole or not at all, the picture
/// first. A link with either name is a file that exists; it is replaced itself, not what it leads to.
/// load_map() gives back what pixel_of_cell() keeps; size, resolution and origin exactly. Throws
/// std::runtime_error: a folder that is not there, a file that cannot be written, thresholds without room, a
/// PGM in mode `scale` for cells that are unknown, a file that exists where that is refused.
void save_map(const OccupancyGrid& grid, const std::filesystem::path& yaml, const MapShades& shades,
              ImageFormat format = ImageFormat::pgm, Existing existing = Existing::replace);

/// The file that a map's URL names: a path, relative to the working directory, or file:// with an absolute
/// one. Nothing for another scheme, another host, or no path at all.
std::optional<std::filesystem::path> path_of_url(std::string_view url);

}  // namespace bw
