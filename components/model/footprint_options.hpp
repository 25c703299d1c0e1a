// The parameters by which Nav2's costmaps are told the robot's footprint.
#pragma once

#include <string>
#include <utility>

#include "components/model/footprint_field.hpp"

namespace bw {

struct FootprintOptions {
  std::string footprint;
  double robot_radius = 0.0;
  double footprint_padding = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("footprint", footprint,
      footprint_field("the robot's outline from now on, for every component: \"[[x, y], [x, y], [x, y]]\" "
                      "in base_link; empty: robot_radius"));
    v("robot_radius", robot_radius,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc = "the robot is a disc from now on, for every component; 0: as section robot has it"});
    v("footprint_padding", footprint_padding,
      {.unit = "m", .min = 0, .max = 1, .doc = "added to the footprint all round"});
  }

  bool operator==(const FootprintOptions&) const = default;
};

/// What they say of a robot that is `otherwise`. The text has been checked.
inline Footprint footprint_of(const FootprintOptions& options, const Footprint& otherwise) {
  FootprintResult told = footprint_of(options.footprint, options.robot_radius);
  const bool says_nothing = !told.fault.empty() || !(told.footprint.radius > 0.0);
  return padded(says_nothing ? otherwise : told.footprint, options.footprint_padding);
}

}  // namespace bw
