// How likely it is that a laser beam ends at a position of the map: the likelihood field (Thrun, Burgard and
// Fox, Probabilistic Robotics, 6.4), as AMCL has it.
//
//   p(end) = z_hit exp(-d^2 / (2 sigma_hit^2)) + z_rand / kLaserMaxRange
//
// with d the exact distance from the end's cell to the nearest obstacle cell (centre to centre), at most
// laser_likelihood_max_dist. Where nobody has seen the map, and outside of it, an end says nothing: there p
// is at least 1 / kLaserMaxRange, as for any position along the beam, which is more than far from everything
// in the known part and much less than at an obstacle.
#pragma once

#include <cstddef>
#include <vector>

#include "components/localization/laser/likelihood_field_options.hpp"
#include "components/model/occupancy_grid.hpp"

namespace bw::localization {

class LikelihoodField {
 public:
  /// Empty: no cell, p = 1 / kLaserMaxRange everywhere.
  LikelihoodField() : LikelihoodField(OccupancyGrid{}, {}) {}
  /// Throws std::runtime_error when the grid's sizes do not fit its cells, its resolution is not positive or
  /// its origin not finite.
  LikelihoodField(const OccupancyGrid& map, const LikelihoodFieldOptions& options);

  /// From the cell at (x, y) in the map's frame [m] to the nearest obstacle, at most
  /// laser_likelihood_max_dist.
  double distance(double x, double y) const;
  /// False in cells that nobody has seen and outside of the map.
  bool known(double x, double y) const;
  /// log p(end at (x, y)).
  double log_likelihood(double x, double y) const;

  const LikelihoodFieldOptions& options() const { return options_; }

  /// The table of log p for kernels: row-major, the map's cells with a border around, whose outermost cells
  /// stand for all that is further out.
  const std::vector<float>& log_table() const { return log_p_; }
  int width() const { return width_; }
  int height() const { return height_; }
  double resolution() const { return resolution_; }
  /// Lower left corner of cell (0, 0) of the table, in the map's frame [m].
  const Vector2& origin() const { return origin_; }

 private:
  std::size_t cell(double x, double y) const;
  float log_p(float signed_distance) const;

  LikelihoodFieldOptions options_;
  double resolution_ = 1.0;
  Vector2 origin_{0.0, 0.0};
  int width_ = 1;
  int height_ = 1;
  std::vector<float> distance_;  ///< [m]; negative where nobody has seen the map
  std::vector<float> log_p_;
};

}  // namespace bw::localization
