// Parameters of the component, beside the algorithm's. Names as in slam_toolbox.
#pragma once

#include <string>
#include <vector>

#include "components/slam/slam_options.hpp"

namespace bw::slam {

struct MapStartPose {
  double x = 0.0;
  double y = 0.0;
  double yaw = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("yaw", yaw, {.unit = "rad", .min = -3.1416, .max = 3.1416, .doc = "in map"});
  }
};

struct SlamParameters {
  SlamOptions algorithm;
  MapStartPose map_start_pose;
  double map_update_interval = 2.0;
  std::string folder = "run/maps";
  bool overwrite = false;

  template <class Visitor>
  void fields(Visitor& v) {
    algorithm.fields(v);
    v("map_start_pose", map_start_pose, {.doc = "where the robot stands in the map when it begins"});
    v("map_update_interval", map_update_interval,
      {.unit = "s", .min = 0.1, .max = 60, .doc = "time between two messages of map"});
    v("folder", folder,
      {.path = true,
       .doc = "where maps are saved, and nowhere else; the default is below the working directory"});
    v("overwrite", overwrite, {.doc = "a map takes the place of one with its name"});
  }
};

}  // namespace bw::slam
