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
  bool do_loop_closing = true;

  /// [m] travel over which scans make one submap; the next is begun half way
  double submap_length = 4.0;
  /// [m] submaps whose walls lie farther apart than this, with what is unsure, are not compared
  double loop_search_maximum_distance = 12.0;
  /// One standard deviation of odometry: of a turn of 1 rad [rad], of 1 m of travel [m], and of the heading after 1 m
  /// [rad]. Where learning begins (OdometryTrust): a base of average encoders
  double odometry_turn_noise = 0.1;
  double odometry_travel_noise = 0.05;
  double odometry_heading_noise = 0.1;

  /// Scans that all at once do not meet the map are kept out of it (Tracked::held): for whoever looks where the
  /// robot is then, since nothing else ends it
  bool holds_back = false;

  template <class Visitor>
  void fields(Visitor& v) {
    v("resolution", resolution, {.unit = "m", .min = 0.01, .max = 0.2, .doc = "edge of a cell of the map"});
    v("max_laser_range", max_laser_range,
      {.unit = "m", .min = 1, .max = 65, .doc = "beams that end farther away are not used"});
    v("minimum_travel_distance", minimum_travel_distance,
      {.unit = "m", .min = 0, .max = 5, .doc = "a scan enters the map after so much travel"});
    v("minimum_travel_heading", minimum_travel_heading,
      {.unit = "rad",
       .min = 0,
       .max = std::numbers::pi,
       .doc = "a scan enters the map after so much turning"});
    v("do_loop_closing", do_loop_closing, {.doc = "recognise places that were seen before"});
  }
  /// What code alone sets.
  template <class Visitor>
  void fixed_fields(Visitor& v) {
    v("submap_length", submap_length, {.min = 0.1, .max = 100});
    v("loop_search_maximum_distance", loop_search_maximum_distance, {.min = 0, .max = 1000});
    v("odometry_turn_noise", odometry_turn_noise, {.min = 0, .max = 10});
    v("odometry_travel_noise", odometry_travel_noise, {.min = 0, .max = 10});
    v("odometry_heading_noise", odometry_heading_noise, {.min = 0, .max = 10});
  }
};

}  // namespace bw::slam
