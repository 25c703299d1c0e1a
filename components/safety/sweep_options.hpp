// What makes a sweep usable. Defaults suit lasers of 0.25 to 1 degree.
#pragma once

#include <cstdint>

#include "runtime/base/field.hpp"

namespace bw::safety {

struct SweepOptions {
  std::int64_t min_points = 3;
  /// [m] how far ranges of neighbouring beams may differ to agree
  static constexpr double kPointSpacing = 0.1;
  std::int64_t min_returns = 3;
  /// share of unknown beams beyond which a sweep counts as lost
  static constexpr double kMaxUnknown = 0.7;
  /// [m] things up to this width may be the legs of somebody wider
  static constexpr double kNarrowWidth = 0.4;

  template <class Visitor>
  void fields(Visitor& v) {
    v("min_points", min_points,
      {.min = 1,
       .max = 5,
       .doc =
           "of five neighbouring beams, so many must agree before a return counts; raise it when the robot "
           "stops for rain or dust"});
    v("min_returns", min_returns,
      {.min = 0,
       .max = 10000,
       .doc =
           "a sweep that hits less although things were just seen is taken for a broken laser; 0: never, where "
           "people come and go from one sweep to the next, as in recordings"});
    v.retired({"point_spacing", "max_unknown", "narrow_width"}, "a constant of sweep_options.hpp");
  }
};

}  // namespace bw::safety
