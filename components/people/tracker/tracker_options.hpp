// Parameters of the tracker. Defaults suit a laser near the floor with 5 to 40 sweeps per second.
#pragma once

#include "runtime/parameters/field.hpp"

namespace bw::people {

struct TrackerOptions {
  double person_radius = 0.3;
  double longest_gap = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("person_radius", person_radius, {.unit = "m", .min = 0.05, .max = 1, .doc = "reported of everybody"});
    v("longest_gap", longest_gap,
      {.unit = "s", .min = 0.1, .max = 60, .doc = "silence or jump back in time that forgets everybody"});
  }
};

}  // namespace bw::people
