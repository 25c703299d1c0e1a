// Whom a rule of velocities looks at: the fields that hrvo and orca have in common, each with defaults of its
// own.
#pragma once

namespace bw {

template <class Options, class Visitor>
void neighbour_fields(Options& o, Visitor& v) {
  v("margin", o.margin,
    {.unit = "m",
     .min = 0,
     .max = 5,
     .doc = "added to the sum of the radii; raise it when the base follows velocities slowly"});
  v("neighbour_range", o.neighbour_range,
    {.unit = "m",
     .min = 0.1,
     .max = 100,
     .doc = "neighbours further away are not looked at; lower it when the robot yields too early"});
}

}  // namespace bw
