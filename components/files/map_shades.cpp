#include "components/files/map_shades.hpp"

#include <algorithm>
#include <cmath>

#include "components/model/occupancy_grid.hpp"

namespace bw {
namespace {

constexpr double kWhite = 255.0;
constexpr double kLeastApart = 0.01;

/// map_server's shade for what is not known, where the thresholds leave it between them. With Nav2's defaults
/// they do not: there 205 would be read as free.
std::uint8_t unknown_pixel(const MapShades& shades) {
  constexpr double kCustomary = 205.0;
  const double p = 1.0 - kCustomary / kWhite;
  if (p >= shades.free_thresh && p <= shades.occupied_thresh) return static_cast<std::uint8_t>(kCustomary);
  const double middle = (shades.free_thresh + shades.occupied_thresh) / 2.0;
  return static_cast<std::uint8_t>(std::lround(kWhite * (1.0 - middle)));
}

std::uint8_t free_pixel(const MapShades& shades) { return 1.0 / kWhite < shades.free_thresh ? 254 : 255; }

std::uint8_t trinary_pixel(const MapShades& shades, std::int8_t cell) {
  if (cell < 0 || cell > OccupancyGrid::kOccupied) return unknown_pixel(shades);
  if (cell <= std::lround(100.0 * shades.free_thresh)) return free_pixel(shades);
  return cell >= std::lround(100.0 * shades.occupied_thresh) ? 0 : unknown_pixel(shades);
}

std::optional<std::uint8_t> scale_pixel(const MapShades& shades, std::int8_t cell) {
  if (cell < 0 || cell > OccupancyGrid::kOccupied) return std::nullopt;
  if (cell == OccupancyGrid::kFree) return free_pixel(shades);
  if (cell == OccupancyGrid::kOccupied) return std::uint8_t{0};
  const double share = (cell - 1) / 98.0;
  const double p = shades.free_thresh + share * (shades.occupied_thresh - shades.free_thresh);
  // Rounding must not carry the shade beyond a threshold, where it would mean something else.
  const double darkest = std::ceil(kWhite * (1.0 - shades.occupied_thresh));
  const double lightest = std::floor(kWhite * (1.0 - shades.free_thresh));
  return static_cast<std::uint8_t>(std::clamp(std::round(kWhite * (1.0 - p)), darkest, lightest));
}

}  // namespace

std::int8_t cell_of_shade(const MapShades& shades, double shade) {
  if (shades.mode == MapMode::raw) {
    const long value = std::lround(shade * kWhite);
    return value <= OccupancyGrid::kOccupied ? static_cast<std::int8_t>(value) : OccupancyGrid::kUnknown;
  }
  const double p = shades.negate ? shade : 1.0 - shade;
  if (p > shades.occupied_thresh) return OccupancyGrid::kOccupied;
  if (p < shades.free_thresh) return OccupancyGrid::kFree;
  if (shades.mode == MapMode::trinary) return OccupancyGrid::kUnknown;
  const double range = shades.occupied_thresh - shades.free_thresh;
  const double share = range > 0.0 ? (p - shades.free_thresh) / range : 0.5;
  return static_cast<std::int8_t>(1 + std::lround(98.0 * share));
}

std::optional<std::string> fault_of(const MapShades& shades) {
  if (!(shades.free_thresh > 0.0 && shades.occupied_thresh < 1.0))
    return "free_thresh and occupied_thresh must lie between 0 and 1";
  if (!(shades.occupied_thresh - shades.free_thresh >= kLeastApart))
    return "occupied_thresh must be at least 0.01 above free_thresh: a shade must lie between them";
  return std::nullopt;
}

std::optional<std::uint8_t> pixel_of_cell(const MapShades& shades, std::int8_t cell) {
  switch (shades.mode) {
    case MapMode::trinary:
      return trinary_pixel(shades, cell);
    case MapMode::scale:
      return scale_pixel(shades, cell);
    case MapMode::raw:
      break;
  }
  return cell < 0 || cell > OccupancyGrid::kOccupied ? std::uint8_t{255} : static_cast<std::uint8_t>(cell);
}

}  // namespace bw
