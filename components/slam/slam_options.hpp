// Parameters of SLAM. Names as in slam_toolbox where it has one.
#pragma once

#include <numbers>

#include "runtime/base/field.hpp"

namespace bw::slam {

struct SlamOptions {
  double resolution = 0.05;
  double max_laser_range = 20.0;
  double minimum_travel_distance = 0.2;
  double minimum_travel_heading = 0.2;
  double submap_length = 4.0;
  bool do_loop_closing = true;
  double loop_search_maximum_distance = 12.0;

  /// [rad/rad, m/m, rad/m] one standard deviation of odometry after turning and driving, and what each step adds
  double odometry_turn_noise = 0.1;
  double odometry_travel_noise = 0.05;
  double odometry_heading_noise = 0.1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("resolution", resolution, {.unit = "m", .min = 0.01, .max = 0.2, .doc = "edge of a cell of the map"});
    v("max_laser_range", max_laser_range,
      {.unit = "m", .min = 1, .max = 100, .doc = "beams that end farther away are not used"});
    v("minimum_travel_distance", minimum_travel_distance,
      {.unit = "m", .min = 0, .max = 5, .doc = "a scan enters the map after so much travel"});
    v("minimum_travel_heading", minimum_travel_heading,
      {.unit = "rad",
       .min = 0,
       .max = std::numbers::pi,
       .doc = "a scan enters the map after so much turning"});
    v("submap_length", submap_length,
      {.unit = "m", .min = 1, .max = 50, .doc = "travel over which scans make one submap"});
    v("do_loop_closing", do_loop_closing, {.doc = "recognise places that were seen before"});
    v("loop_search_maximum_distance", loop_search_maximum_distance,
      {.unit = "m", .min = 1, .max = 100, .doc = "submaps farther away than this are not searched"});
    v("odometry_turn_noise", odometry_turn_noise,
      {.min = 0, .max = 1, .doc = "standard deviation of a turn by odometry, of its size"});
    v("odometry_travel_noise", odometry_travel_noise,
      {.min = 0, .max = 1, .doc = "standard deviation of travel by odometry, of its length"});
    v("odometry_heading_noise", odometry_heading_noise,
      {.unit = "rad/m", .min = 0, .max = 1, .doc = "standard deviation of the heading by travel"});
  }
};

}  // namespace bw::slam
