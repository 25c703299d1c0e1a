// What the map server serves: a map file, an empty area, or either with walls, boxes and the shapes of a
// recording drawn in.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "components/model/occupancy_grid.hpp"
#include "components/model/shape_options.hpp"
#include "runtime/base/field.hpp"

namespace bw {

/// Free floor; used when there is no map file.
struct AreaOptions {
  double x = 0.0;
  double y = 0.0;
  double length = 0.0;
  double width = 0.0;
  double resolution = 0.05;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "lower left corner, in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "lower left corner, in map"});
    v("length", length, {.unit = "m", .min = 0, .max = 1e4, .doc = "extent along x"});
    v("width", width, {.unit = "m", .min = 0, .max = 1e4, .doc = "extent along y"});
    v("resolution", resolution, {.unit = "m", .min = 0.001, .max = 10, .doc = "edge of a cell"});
  }
};

struct MapServerOptions {
  std::string map;
  AreaOptions area;
  std::string track_walls;
  std::string track_circles;
  std::vector<WallOptions> walls;
  std::vector<BoxOptions> boxes;

  template <class Visitor>
  void fields(Visitor& v) {
    v("map", map, {.first = true, .doc = "map file (YAML beside a PGM or PNG); empty: the area"});
    v("area", area, {.doc = "free floor to draw walls and boxes on"});
    v("track_walls", track_walls,
      {.doc =
           "file of a recording's walls (CSV x1_m,y1_m,x2_m,y2_m), drawn over the map or area; empty: none"});
    v("track_circles", track_circles,
      {.doc = "file of a recording's trees (CSV x_m,y_m,r_m), drawn over the map or area; empty: none"});
    v("walls", walls, {.doc = "thin walls, drawn over the map or area"});
    v("boxes", boxes, {.doc = "filled boxes, drawn over the map or area"});
  }

  std::optional<std::string> violated_rule() const;
};

/// The area as a free grid. The options' rules must hold.
OccupancyGrid area_grid(const AreaOptions& area);

/// Draws walls and boxes; what lies outside the grid is left out.
void draw_shapes(OccupancyGrid& grid, const std::vector<WallOptions>& walls,
                 const std::vector<BoxOptions>& boxes);

}  // namespace bw
