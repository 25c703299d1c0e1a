// What the outline of a cluster looks like, in numbers: after Arras, Martinez Mozos and Burgard, ICRA 2007;
// and what stands about it.
#pragma once

#include <array>
#include <cstddef>

#include "components/people/detector/disc_fit.hpp"
#include "components/people/detector/neighbours.hpp"
#include "components/people/detector/outline.hpp"

namespace bw::people {

enum class Feature : std::size_t {
  points,               ///< number of them
  distance,             ///< from the scanner [m]
  width,                ///< from the first to the last point [m]
  across,               ///< extent at right angles to the line of sight [m]
  depth,                ///< extent along it [m]
  spread,               ///< root mean square distance from the mean [m]
  median_deviation,     ///< mean distance from the median point [m]
  linearity,            ///< root mean square distance from the best line [m]
  circle_radius,        ///< of the free circle fit, at most 1 [m]
  circle_residual,      ///< root mean square distance from it [m]
  leg_radius,           ///< of the disc fit, which expects a leg [m]
  leg_residual,         ///< root mean square distance from that disc [m]
  boundary_length,      ///< sum of the steps from point to point [m]
  boundary_regularity,  ///< standard deviation of those steps [m]
  curvature,  ///< mean over triples of points, 4 area / (product of sides), towards the scanner positive
              ///< [1/m]
  inscribed_angle,   ///< mean angle under which inner points see the two ends [rad]
  inscribed_spread,  ///< standard deviation of that angle [rad]
  bulge,             ///< of the middle over the chord, towards the scanner positive, as a share of the width
  right_jump,        ///< how much farther the neighbouring beam sees, at most 2 either way [m]
  left_jump,
  least_jump,      ///< the smaller of both
  spacing,         ///< between beams at that distance [m]
  nearest,         ///< distance of the nearest narrow cluster beside it, at most 2 [m]
  second_nearest,  ///< of the next one [m]
  nearest_width,   ///< of the nearest [m]
  about,           ///< how many there are within 1 m
  count
};

inline constexpr std::size_t kFeatures = static_cast<std::size_t>(Feature::count);
extern const std::array<const char*, kFeatures> kFeatureNames;

struct Features {
  std::array<float, kFeatures> values{};
  float& operator[](Feature f) { return values[static_cast<std::size_t>(f)]; }
  float operator[](Feature f) const { return values[static_cast<std::size_t>(f)]; }
};

/// All finite. `leg` is the disc fitted to the outline.
Features features_of(const Outline& outline, const DiscFit& leg, const Neighbours& neighbours);

}  // namespace bw::people
