// What makes a sweep usable. Defaults suit lasers of 0.25 to 1 degree.
#pragma once

#include <cstdint>

#include "runtime/base/field.hpp"

namespace bw::safety {

struct SweepOptions {
  std::int64_t min_points = 3;
  double point_spacing = 0.1;
  std::int64_t min_returns = 3;
  double max_unknown = 0.7;
  double narrow_width = 0.4;

  template <class Visitor>
  void fields(Visitor& v) {
    v("min_points", min_points,
      {.min = 1,
       .max = 5,
       .doc =
           "of five neighbouring beams, so many must agree before a return counts; raise it when the robot "
           "stops for rain or dust"});
    v("point_spacing", point_spacing,
      {.unit = "m",
       .min = 0.005,
       .max = 1,
       .doc = "how far ranges of neighbouring beams may differ to agree"});
    v("min_returns", min_returns,
      {.min = 0,
       .max = 10000,
       .doc =
           "a sweep that hits less although things were just seen is taken for a broken laser; 0: never, where "
           "people come and go from one sweep to the next, as in recordings"});
    v("max_unknown", max_unknown,
      {.min = 0, .max = 1, .doc = "share of unknown beams beyond which a sweep counts as lost"});
    v("narrow_width", narrow_width,
      {.unit = "m", .min = 0, .max = 2, .doc = "things up to this width may be the legs of somebody wider"});
  }
};

}  // namespace bw::safety
