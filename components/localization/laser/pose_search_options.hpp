// Parameters of the search over the whole map.
#pragma once

#include "runtime/base/field.hpp"

namespace bw::localization {

struct PoseSearchOptions {
  double step = 0.1;
  double angle_step = 0.035;
  double clearance = 0.1;
  int hypotheses = 20;
  double apart = 0.5;
  /// [rad] poses near each other with less than this between their headings are one
  static constexpr double kApartAngle = 0.35;
  /// poses that fit worse are not reported
  static constexpr double kLeastFit = 0.4;
  double margin = 0.25;
  int candidates = 20000;

  template <class Visitor>
  void fields(Visitor& v) {
    v("step", step,
      {.unit = "m",
       .min = 0.01,
       .max = 1,
       .doc = "distance between positions that are tried; finer finds narrow fits and takes longer"});
    v("angle_step", angle_step,
      {.unit = "rad",
       .min = 0.005,
       .max = 0.2,
       .doc = "angle between headings that are tried; finer finds narrow fits and takes longer"});
    v("clearance", clearance,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc = "the base is never nearer than this to an obstacle of the map"});
    v("hypotheses", hypotheses, {.min = 1, .max = 1000, .doc = "poses that are reported at most"});
    v("apart", apart, {.unit = "m", .min = 0.1, .max = 10, .doc = "two poses nearer than this"});
    v("margin", margin,
      {.min = 0,
       .max = 1,
       .doc = "poses that fit by so much worse than the best of the map are not reported"});
    v("candidates", candidates,
      {.min = 100, .max = 10000000, .doc = "how many coarse cells are looked into at most, the best first"});
  }
};

}  // namespace bw::localization
