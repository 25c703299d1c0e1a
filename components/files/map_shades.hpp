// What the shades of a map's picture mean, as ROS's map_server reads and writes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "runtime/base/choice.hpp"

namespace bw {

enum class MapMode {
  trinary,  ///< free, occupied or unknown
  scale,    ///< and 1 to 99 in proportion between the thresholds
  raw,      ///< the pixel's own value
};
constexpr auto choice_table(MapMode) {
  return choices<MapMode>({{MapMode::trinary, "trinary"}, {MapMode::scale, "scale"}, {MapMode::raw, "raw"}});
}

/// With shade s (0 black to 1 white) and p = 1 - s (s if negated): occupied where p > occupied_thresh, free
/// where p < free_thresh; between the two unknown, or in `scale` 1 to 99 in proportion. `raw`: the value on
/// the scale 0 to 255, unknown above 100.
struct MapShades {
  MapMode mode = MapMode::trinary;
  bool negate = false;
  double free_thresh = 0.25;
  double occupied_thresh = 0.65;
};

std::int8_t cell_of_shade(const MapShades& shades, double shade);

/// What keeps pictures of these shades from being read back; nothing: they can be.
std::optional<std::string> fault_of(const MapShades& shades);

/// The pixel, 0 black to 255 white, that cell_of_shade() reads as the cell (never negated; fault_of() must be
/// empty). `trinary` first takes cells up to free_thresh (0.25 is 25) as free and from occupied_thresh on as
/// occupied, others as unknown, as Nav2's map_saver does. `scale` keeps 1 to 99 within one, as near as 8 bits
/// between the default thresholds come; nothing for an unknown cell, which is a transparent pixel there.
std::optional<std::uint8_t> pixel_of_cell(const MapShades& shades, std::int8_t cell);

}  // namespace bw
