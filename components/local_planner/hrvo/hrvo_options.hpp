// Parameters of the velocity obstacles (spec 5.3).
#pragma once

#include "runtime/parameters/field.hpp"

namespace bw::hrvo {

struct HrvoOptions {
  double neighbour_range = 8.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("neighbour_range", neighbour_range,
      {.unit = "m", .min = 0.1, .max = 100, .doc = "neighbours further away are not looked at"});
  }
};

}  // namespace bw::hrvo
