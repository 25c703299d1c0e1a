// Parameters of the detector. Defaults suit a laser at the height of shins, 0.3 to 0.5 degrees between beams.
#pragma once

#include "runtime/base/field.hpp"

namespace bw::people {

struct ClusterOptions {
  /// [m] neighbouring points farther apart part two clusters
  static constexpr double kJump = 0.13;
  /// this share of the distance between beams at that range is added to jump (set by code alone)
  double growth = 0.5;
  /// [m] used in place of jump where background meets foreground, so that a leg leaves its wall
  static constexpr double kEdgeJump = 0.05;
  /// this many unusable beams in a row do not part a cluster
  static constexpr int kBridge = 2;
  /// clusters of fewer points are noise (set by code alone)
  int min_points = 2;
  double max_range = 12.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("max_range", max_range,
      {.unit = "m", .min = 0.5, .max = 100, .doc = "points farther away are not looked at"});
    v.retired({"min_points"}, "set by code alone, in detector_options.hpp");
  }
};

struct BackgroundOptions {
  /// [m] how near to an occupied cell of the map a point is background
  static constexpr double kMapTolerance = 0.25;
  /// [m] edge of a cell of the local background
  static constexpr double kCell = 0.1;
  /// [s] what stood for this long is background
  static constexpr double kStood = 2.5;
  /// a cell seen through loses its time so many times faster
  static constexpr double kForget = 3.0;
  /// [m] nothing becomes background within this distance of a tracked person
  static constexpr double kKeepOut = 0.4;
  /// a cluster is background when this share of its points is
  static constexpr double kShare = 0.6;
};

struct LegFitOptions {
  /// [m] radius of a leg at the laser's height
  static constexpr double kRadius = 0.07;
  /// [m] standard deviation of that radius among people
  static constexpr double kRadiusSigma = 0.02;
  /// [m] standard deviation of a range
  static constexpr double kRangeNoise = 0.015;
};

struct DetectorOptions {
  ClusterOptions clusters;
  BackgroundOptions background;
  LegFitOptions legs;

  template <class Visitor>
  void fields(Visitor& v) {
    v("clusters", clusters, {.doc = "which beams belong together"});
    v.retired({"legs", "background"}, "a constant of detector_options.hpp");
  }
};

}  // namespace bw::people
