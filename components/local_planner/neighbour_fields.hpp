// Whom a rule of velocities looks at: the fields that hrvo and orca have in common, each with defaults of its own.
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
  v("view_angle", o.view_angle,
    {.unit = "rad",
     .min = 0.1,
     .max = 6.283185307179587,
     .doc = "neighbours outside this angle, centred on the heading, are not looked at"});
  v("max_neighbours", o.max_neighbours,
    {.min = 1,
     .max = 100,
     .doc = "nearest movers looked at, and as many static obstacles: neither crowds out the other"});
  v("point_spacing", o.point_spacing,
    {.unit = "m",
     .min = 0,
     .max = 5,
     .doc = "obstacle points closer than this to a nearer one are left out; at most the radius they get"});
}

}  // namespace bw
