// Parameters of the detector. Defaults suit a laser at the height of shins, 0.3 to 0.5 degrees between beams.
#pragma once

#include "runtime/base/field.hpp"

namespace bw::people {

struct ClusterOptions {
  double jump = 0.13;
  double growth = 0.5;
  double edge_jump = 0.05;
  int bridge = 2;
  int min_points = 2;
  double max_range = 12.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("jump", jump,
      {.unit = "m", .min = 0.01, .max = 1, .doc = "neighbouring points farther apart part two clusters"});
    v("growth", growth,
      {.min = 0,
       .max = 5,
       .doc = "this share of the distance between beams at that range is added to jump; raise it for "
              "coarse scanners"});
    v("edge_jump", edge_jump,
      {.unit = "m",
       .min = 0.005,
       .max = 1,
       .doc = "used in place of jump where background meets foreground, so that a leg leaves its wall"});
    v("bridge", bridge,
      {.min = 0, .max = 20, .doc = "this many unusable beams in a row do not part a cluster"});
    v("min_points", min_points,
      {.min = 1,
       .max = 100,
       .doc = "clusters of fewer points are noise; raise it for fine or noisy scanners"});
    v("max_range", max_range,
      {.unit = "m", .min = 0.5, .max = 100, .doc = "points farther away are not looked at"});
  }
};

struct BackgroundOptions {
  bool use_map = true;
  double map_tolerance = 0.25;
  double cell = 0.1;
  double stood = 2.5;
  double forget = 3.0;
  double keep_out = 0.4;
  double share = 0.6;

  template <class Visitor>
  void fields(Visitor& v) {
    v("use_map", use_map, {.doc = "what lies on the map's walls is background, if there is a map"});
    v("map_tolerance", map_tolerance,
      {.unit = "m",
       .min = 0,
       .max = 1,
       .doc = "how near to an occupied cell of the map a point is background; raise it when the pose in "
              "the map errs more than 0.1 m and 1 degree"});
    v("cell", cell, {.unit = "m", .min = 0.02, .max = 0.5, .doc = "edge of a cell of the local background"});
    v("stood", stood,
      {.unit = "s",
       .min = 0.2,
       .max = 60,
       .doc = "what stood for this long is background; raise it where people stand about"});
    v("forget", forget,
      {.min = 0.1, .max = 100, .doc = "a cell seen through loses its time so many times faster"});
    v("keep_out", keep_out,
      {.unit = "m",
       .min = 0,
       .max = 2,
       .doc = "nothing becomes background within this distance of a tracked person"});
    v("share", share,
      {.min = 0.1, .max = 1, .doc = "a cluster is background when this share of its points is"});
  }
};

struct LegFitOptions {
  double radius = 0.07;
  double radius_sigma = 0.02;
  double range_noise = 0.015;

  template <class Visitor>
  void fields(Visitor& v) {
    v("radius", radius,
      {.unit = "m", .min = 0.02, .max = 0.2, .doc = "radius of a leg at the laser's height"});
    v("radius_sigma", radius_sigma,
      {.unit = "m", .min = 0.001, .max = 0.1, .doc = "standard deviation of that radius among people"});
    v("range_noise", range_noise,
      {.unit = "m", .min = 0.001, .max = 0.2, .doc = "standard deviation of a range"});
  }
};

struct DetectorOptions {
  ClusterOptions clusters;
  BackgroundOptions background;
  LegFitOptions legs;

  template <class Visitor>
  void fields(Visitor& v) {
    v("clusters", clusters, {.doc = "which beams belong together"});
    v("background", background, {.doc = "what has long stood there"});
    v("legs", legs, {.doc = "where the centre of a leg is"});
  }
};

}  // namespace bw::people
