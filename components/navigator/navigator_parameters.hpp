// What the graph says of the navigator beyond its judgements: where to go first, how often to look.
#pragma once

#include "components/navigator/navigator_options.hpp"

namespace bw {

/// A goal of the graph itself, in map.
struct GoalParameters {
  bool enabled = false;
  double x = 0.0;
  double y = 0.0;
  double theta = 0.0;
  double delay = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled, {.doc = "drive to this goal after the start; otherwise wait for /goal_pose"});
    v("x", x, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("y", y, {.unit = "m", .min = -1e5, .max = 1e5, .doc = "in map"});
    v("theta", theta, {.unit = "rad", .min = -3.1416, .max = 3.1416, .doc = "heading in map"});
    v("delay", delay,
      {.unit = "s",
       .min = 0,
       .max = 3600,
       .doc = "time after the start before the goal is taken up, and never before the pose is known"});
  }
};

struct NavigatorParameters : NavigatorOptions {
  double rate = 20.0;
  double pose_timeout = 0.5;
  double feedback_period = 0.2;
  GoalParameters goal;

  template <class Visitor>
  void fields(Visitor& v) {
    NavigatorOptions::fields(v);
    v("rate", rate,
      {.unit = "Hz",
       .min = 1,
       .max = 200,
       .doc = "how many times a second the navigator looks at the drive"});
    v("pose_timeout", pose_timeout, {.unit = "s", .min = 0.05, .max = 10, .doc = "an older pose means lost"});
    v("feedback_period", feedback_period,
      {.unit = "s", .min = 0.02, .max = 60, .doc = "time between two status messages while driving"});
    v("goal", goal, {.doc = "a goal of the graph itself"});
  }
};

}  // namespace bw
