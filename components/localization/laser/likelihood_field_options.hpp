// Parameters of the comparison of laser beams with a map. Names as in AMCL where it has one.
#pragma once

#include "runtime/base/field.hpp"

namespace bw::localization {

struct LikelihoodFieldOptions {
  double z_hit = 0.5;
  double z_rand = 0.5;
  double sigma_hit = 0.2;
  /// [m] ends further than this from the map's obstacles are all alike
  static constexpr double kLaserLikelihoodMaxDist = 2.0;
  /// [m] range over which the ends of z_rand are spread
  static constexpr double kLaserMaxRange = 10.0;
  /// beams of one sweep share errors: together they count as so many independent ones (set by code alone)
  double effective_beams = 15.0;
  /// smallest occupancy of a map cell that is an obstacle
  static constexpr int kOccupiedAt = 65;

  template <class Visitor>
  void fields(Visitor& v) {
    v("z_hit", z_hit,
      {.min = 0.01, .max = 1, .doc = "weight of beams that end at what the map holds; lower it in crowds"});
    v("z_rand", z_rand,
      {.min = 0.01, .max = 1, .doc = "weight of beams that end anywhere; raise it in crowds"});
    v("sigma_hit", sigma_hit,
      {.unit = "m", .min = 0.01, .max = 1, .doc = "standard deviation of an end from the nearest obstacle"});
    v.retired({"occupied_at", "laser_max_range"}, "a constant of likelihood_field_options.hpp");
  }
};

}  // namespace bw::localization
