// What hrvo and orca have in common: the fields, each with defaults of its own.
#pragma once

namespace bw {

template <class Options, class Visitor>
void neighbour_fields(Options& o, Visitor& v) {
  v("margin", o.margin,
    {.unit = "m",
     .min = 0,
     .max = 5,
     .doc = "added to the sum of the radii; raise it when the base follows velocities slowly"});
  v("lookahead", o.lookahead,
    {.unit = "m",
     .min = 0.2,
     .max = 50,
     .doc = "the planner of this name aims at the point of the plan this far ahead; lower it to keep closer "
            "to the plan"});
  v.retired({"neighbour_range", "reciprocity"}, "set by code alone, in the options of the planner");
}

}  // namespace bw
