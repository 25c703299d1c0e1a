#include "components/localization/laser/likelihood_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "components/model/distance_transform.hpp"

namespace bw::localization {
namespace {

void check_grid(const OccupancyGrid& map) {
  if (map.width < 0 || map.height < 0 ||
      map.cells.size() != static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.height)) {
    throw std::runtime_error("likelihood field: the sizes of the map do not fit its cells");
  }
  if (!(map.resolution > 0.0) || !std::isfinite(map.resolution)) {
    throw std::runtime_error("likelihood field: the resolution of the map must be positive");
  }
  if (!map.origin.allFinite())
    throw std::runtime_error("likelihood field: the origin of the map is not finite");
}

// An end just outside may still belong to a wall at the map's edge; five sigma away none does.
int border_cells(const OccupancyGrid& map, const LikelihoodFieldOptions& options) {
  const double reach = std::min(options.kLaserLikelihoodMaxDist, 5.0 * options.sigma_hit);
  return 1 + static_cast<int>(std::min(std::ceil(reach / map.resolution), 10000.0));
}

OccupancyGrid with_border(const OccupancyGrid& map, int border) {
  OccupancyGrid wide;
  wide.resolution = map.resolution;
  wide.origin = map.origin - Vector2::Constant(border * map.resolution);
  wide.width = map.width + 2 * border;
  wide.height = map.height + 2 * border;
  wide.cells.assign(static_cast<std::size_t>(wide.width) * static_cast<std::size_t>(wide.height),
                    OccupancyGrid::kUnknown);
  for (int row = 0; row < map.height; ++row) {
    std::copy_n(map.cells.begin() + static_cast<std::ptrdiff_t>(map.index(0, row)), map.width,
                wide.cells.begin() + static_cast<std::ptrdiff_t>(wide.index(border, row + border)));
  }
  return wide;
}

}  // namespace

LikelihoodField::LikelihoodField(const OccupancyGrid& map, const LikelihoodFieldOptions& options)
    : options_(options) {
  check_grid(map);
  const OccupancyGrid wide = with_border(map, border_cells(map, options));
  resolution_ = wide.resolution;
  origin_ = wide.origin;
  width_ = wide.width;
  height_ = wide.height;
  distance_ = distance_field(wide, {.occupied_at = options.kOccupiedAt, .unknown_is_obstacle = false});
  log_p_.resize(distance_.size());
  const auto farthest = static_cast<float>(options.kLaserLikelihoodMaxDist);
  for (std::size_t i = 0; i < distance_.size(); ++i) {
    distance_[i] = std::min(distance_[i], farthest);
    if (wide.cells[i] < 0) distance_[i] = -distance_[i];
    log_p_[i] = log_p(distance_[i]);
  }
}

float LikelihoodField::log_p(float signed_distance) const {
  const double d = static_cast<double>(signed_distance) / options_.sigma_hit;
  const double p = options_.z_hit * std::exp(-0.5 * d * d) + options_.z_rand / options_.kLaserMaxRange;
  return static_cast<float>(
      std::log(signed_distance < 0.0F ? std::max(p, 1.0 / options_.kLaserMaxRange) : p));
}

std::size_t LikelihoodField::cell(double x, double y) const {
  // Compared before the conversion, so that any number, and none (NaN), has a cell.
  const auto clamped = [](double value, int count) {
    if (!(value > 0.0)) return 0;
    return value < count - 1 ? static_cast<int>(value) : count - 1;
  };
  const int column = clamped((x - origin_.x()) / resolution_, width_);
  const int row = clamped((y - origin_.y()) / resolution_, height_);
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column);
}

double LikelihoodField::distance(double x, double y) const {
  return std::abs(static_cast<double>(distance_[cell(x, y)]));
}
bool LikelihoodField::known(double x, double y) const { return distance_[cell(x, y)] >= 0.0F; }
double LikelihoodField::log_likelihood(double x, double y) const {
  return static_cast<double>(log_p_[cell(x, y)]);
}

}  // namespace bw::localization
