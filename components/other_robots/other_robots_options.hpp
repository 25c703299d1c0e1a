// Parameters of the component other_robots.
#pragma once

#include <string>
#include <vector>

#include "runtime/base/field.hpp"

namespace bw {

struct OtherRobotsOptions {
  std::vector<std::string> robots;
  double radius = 0.0;
  double timeout = 0.5;
  /// [m] a robot less sure of its position than this is what the laser sees of it: standard deviation, the
  /// larger axis; more is wider than a robot
  static constexpr double kMaxDeviation = 0.5;
  /// [m] a track with its centre in a robot's body or this near to it is that robot (set by code alone)
  double body_margin = 0.15;
  /// [m/s^2] by which they may deviate from keeping their velocity (set by code alone)
  double acceleration = 0.2;
  /// [s] how far ahead positions are predicted (set by code alone)
  double prediction_horizon = 4.0;
  /// [s] time between predicted positions (set by code alone)
  double prediction_step = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("robots", robots,
      {.doc =
           "namespaces of the robots about, such as /robot2; the robot's own may be among them and is left out"});
    v("radius", radius, {.unit = "m", .min = 0, .max = 5, .doc = "of their bodies; 0: as this robot's"});
    v("timeout", timeout,
      {.unit = "s",
       .min = 0.05,
       .max = 10,
       .doc = "a robot that is silent for longer is what the laser sees of it"});
    v.retired({"max_deviation", "prediction_horizon", "body_margin", "acceleration"},
              "a constant of other_robots_options.hpp");
  }
};

}  // namespace bw
