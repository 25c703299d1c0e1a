// Parameters of component `local_costmap`.
#pragma once

#include <optional>
#include <string>

#include "components/mapping/costmap/costmap_options.hpp"
#include "components/mapping/obstacle_extraction.hpp"
#include "components/model/footprint_options.hpp"

namespace bw::costmap {

struct LocalCostmapParameters {
  double rate = 10.0;
  /// [s] a sweep waits so long for the odometry of its time (set by code alone)
  double transform_timeout = 0.3;
  /// [s] older tracks do not say where people are (set by code alone)
  double tracks_timeout = 0.5;
  bool use_map = false;
  bool nav2_names = false;
  FootprintOptions footprint;
  GridOptions grid;
  InflationOptions inflation;
  ExtractionOptions obstacles{.tolerance_cells = 0.3};

  template <class Visitor>
  void fields(Visitor& v) {
    v("rate", rate,
      {.unit = "Hz", .min = 0.1, .max = 100, .doc = "most messages per second; each needs a sweep"});
    v("use_map", use_map, {.doc = "cells nobody has seen take what the map says; needs localization"});
    v("nav2_names", nav2_names,
      {.doc =
           "topics and services as those of the costmap inside Nav2's controller_server, for a node in the namespace "
           "local_costmap: costmap, costmap_raw, published_footprint, get_costmap, clear_..."});
    footprint.fields(v);
    grid.fields(v);
    inflation.fields(v);
    v("obstacles", obstacles, {.doc = "shapes for the local planner"});
    v.retired({"transform_timeout", "tracks_timeout"}, "a constant of local_costmap_parameters.hpp");
  }

  std::optional<std::string> violated_rule() const { return grid.violated_rule(); }
};

}  // namespace bw::costmap
