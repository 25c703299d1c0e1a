// Where the centre of a leg is, from the part of it that the laser sees.
#pragma once

#include <span>

#include "components/people/detector/outline.hpp"

namespace bw::people {

struct DiscFit {
  Vector2 center{0.0, 0.0};  ///< in the outline's frame [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity();
  double radius = 0.0;    ///< [m]
  double residual = 0.0;  ///< root mean square distance of the points from the circle [m]
};

/// Most probable disc (Gauss-Newton) given
///   points:  |p_i - c| - r = 0              standard deviation range_noise
///   edges:   distance of c from the ray half a beam beyond the outermost point - r = 0, where nothing hides
///            the edge                        standard deviation of a uniform spread over one beam
///   radius:  r - legs.radius = 0             standard deviation radius_sigma
///   centre:  c - (3/4 radius behind the mean of the points) = 0    standard deviation 0.1 m
/// The radius and the edges hold a centre that few points of a short arc would leave open.
DiscFit fit_disc(const Outline& outline, const LegFitOptions& legs);

/// Two legs that touch in the picture: the point between them. The outline is cut where two discs fit best.
DiscFit fit_two_discs(const Outline& outline, const LegFitOptions& legs);

}  // namespace bw::people
