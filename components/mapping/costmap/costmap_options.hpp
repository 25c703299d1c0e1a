// Parameters of the local costmap. Names as Nav2's where it has one.
#pragma once

#include <optional>
#include <string>

#include "runtime/base/field.hpp"

namespace bw::costmap {

struct GridOptions {
  double width = 10.0;
  double height = 10.0;
  double resolution = 0.05;
  /// [m] nearer returns are not marked (the robot's own parts) (set by code alone)
  double obstacle_min_range = 0.0;
  double obstacle_max_range = 5.0;
  double raytrace_max_range = 7.0;
  /// [m] beams clear nothing this close to their hit: three standard deviations of a range (set by code
  /// alone)
  double hit_margin = 0.03;
  /// [m] hits of neighbouring beams nearer than this are one surface (set by code alone)
  double link_gap = 0.3;
  /// a cell hit in so many sweeps is settled: it keeps for decay_time (set by code alone)
  int settled_hits = 10;
  /// [s] other marked cells fade so long after their last hit (set by code alone)
  double young_time = 0.45;
  double decay_time = 10.0;
  /// [m] nothing is marked within a person's radius and this
  static constexpr double kPeopleMargin = 0.1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("width", width,
      {.unit = "m", .min = 1, .max = 100, .doc = "width of the window around the robot, along x"});
    v("height", height,
      {.unit = "m", .min = 1, .max = 100, .doc = "height of the window around the robot, along y"});
    v("resolution", resolution, {.unit = "m", .min = 0.01, .max = 1, .doc = "edge of a cell"});
    v("obstacle_max_range", obstacle_max_range,
      {.unit = "m", .min = 0.1, .max = 100, .first = true, .doc = "farther returns are not marked"});
    v("raytrace_max_range", raytrace_max_range,
      {.unit = "m", .min = 0.1, .max = 100, .doc = "beams clear cells up to this range"});
    v("decay_time", decay_time,
      {.unit = "s", .min = 0, .max = 1e6, .doc = "settled cells fade so long after their last hit"});
    v.retired({"hit_margin", "link_gap", "settled_hits", "young_time", "people_margin"},
              "a constant of costmap_options.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (width / resolution * (height / resolution) > 4e6) return "the window must not exceed 4 million cells";
    if (obstacle_min_range >= obstacle_max_range)
      return "obstacle_max_range must be greater than obstacle_min_range";
    if (raytrace_max_range < obstacle_max_range)
      return "raytrace_max_range must be at least obstacle_max_range: what cannot be cleared must not be "
             "marked";
    return std::nullopt;
  }
};

struct InflationOptions {
  double inflation_radius = 0.55;
  double cost_scaling_factor = 3.0;
  /// unknown cells near obstacles take costs too (set by code alone)
  bool inflate_unknown = false;
  bool track_unknown_space = true;

  template <class Visitor>
  void fields(Visitor& v) {
    v("inflation_radius", inflation_radius,
      {.unit = "m",
       .min = 0,
       .max = 20,
       .first = true,
       .doc = "cells farther than this from obstacles cost nothing"});
    v("cost_scaling_factor", cost_scaling_factor,
      {.unit = "1/m", .min = 0, .max = 1000, .doc = "how fast the cost falls; raise it to pass closer"});
    v("track_unknown_space", track_unknown_space,
      {.doc =
           "false: cells nobody has seen cost what free ones do, as in the local costmap that Nav2 ships"});
  }
};

}  // namespace bw::costmap
