// Parameters of the comparison of laser beams with a map. Names as in AMCL where it has one.
#pragma once

#include "runtime/base/field.hpp"

namespace bw::localization {

struct LikelihoodFieldOptions {
  double z_hit = 0.5;
  double z_rand = 0.5;
  double sigma_hit = 0.2;
  double laser_likelihood_max_dist = 2.0;
  double laser_max_range = 10.0;
  double effective_beams = 15.0;
  int occupied_at = 65;

  template <class Visitor>
  void fields(Visitor& v) {
    v("z_hit", z_hit,
      {.min = 0.01, .max = 1, .doc = "weight of beams that end at what the map holds; lower it in crowds"});
    v("z_rand", z_rand,
      {.min = 0.01, .max = 1, .doc = "weight of beams that end anywhere; raise it in crowds"});
    v("sigma_hit", sigma_hit,
      {.unit = "m", .min = 0.01, .max = 1, .doc = "standard deviation of an end from the nearest obstacle"});
    v("laser_likelihood_max_dist", laser_likelihood_max_dist,
      {.unit = "m",
       .min = 0.1,
       .max = 20,
       .doc = "ends further than this from the map's obstacles are all alike"});
    v("laser_max_range", laser_max_range,
      {.unit = "m",
       .min = 0.5,
       .max = 1000,
       .doc = "range over which the ends of z_rand are spread; raise it to trust a few mismatched beams "
              "less"});
    v("effective_beams", effective_beams,
      {.min = 1,
       .max = 1000,
       .doc = "beams of one sweep share errors: together they count as so many independent ones"});
    v("occupied_at", occupied_at,
      {.min = 1, .max = 100, .doc = "smallest occupancy of a map cell that is an obstacle"});
  }
};

}  // namespace bw::localization
