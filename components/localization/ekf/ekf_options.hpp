// Parameters of the EKF. Defaults suit a small indoor or campus robot with encoders, gyro, compass, receiver.
#pragma once

#include <optional>
#include <string>

#include "components/localization/measurement_check.hpp"
#include "runtime/base/field.hpp"

namespace bw::localization {

struct BiasOptions {
  bool gyro_bias = true;
  double gyro_bias_sigma = 0.02;
  double gyro_bias_walk = 1e-4;
  bool heading_offset = false;
  double heading_offset_sigma = 0.3;
  double heading_offset_walk = 0.005;

  template <class Visitor>
  void fields(Visitor& v) {
    v("gyro_bias", gyro_bias, {.doc = "estimate the gyro's bias"});
    v("gyro_bias_sigma", gyro_bias_sigma,
      {.unit = "rad/s", .min = 0, .max = 1, .doc = "of the bias at the start"});
    v("gyro_bias_walk", gyro_bias_walk,
      {.unit = "rad/s/sqrt(s)", .min = 0, .max = 1, .doc = "how fast the bias wanders"});
    v("heading_offset", heading_offset,
      {.doc = "estimate a constant error of the compass; needs positions, and a robot that drives"});
    v("heading_offset_sigma", heading_offset_sigma,
      {.unit = "rad", .min = 0, .max = 3.15, .doc = "of the offset at the start"});
    v("heading_offset_walk", heading_offset_walk,
      {.unit = "rad/sqrt(s)", .min = 0, .max = 1, .doc = "how fast the offset wanders"});
  }
};

struct MotionOptions {
  double extrapolation = 0.5;
  double acceleration = 1.0;
  double turn_acceleration = 1.0;
  double silent_speed = 1.0;
  double silent_turn_rate = 1.0;
  double gyro_gap = 0.1;
  double position_walk = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("extrapolation", extrapolation,
      {.unit = "s",
       .min = 0,
       .max = 2,
       .doc = "after the last wheel step the velocity holds this long; then the motion is unknown"});
    v("acceleration", acceleration,
      {.unit = "m/s^2", .min = 0, .max = 100, .doc = "standard deviation while extrapolating"});
    v("turn_acceleration", turn_acceleration,
      {.unit = "rad/s^2", .min = 0, .max = 100, .doc = "standard deviation while extrapolating"});
    v("silent_speed", silent_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 100,
       .doc = "standard deviation of the speed while wheels are silent"});
    v("silent_turn_rate", silent_turn_rate,
      {.unit = "rad/s", .min = 0, .max = 100, .doc = "the same of the turn rate, without a gyro"});
    v("gyro_gap", gyro_gap,
      {.unit = "s", .min = 0.001, .max = 1, .doc = "gyro readings further apart are not integrated"});
    v("position_walk", position_walk,
      {.unit = "m/sqrt(m)",
       .min = 0,
       .max = 10,
       .doc =
           "how fast position and fixes drift apart on the way by what neither declares: skidding sideways, "
           "a receiver whose error wanders; without it such drift is taken for turns"});
  }
};

struct GateOptions {
  bool enabled = true;
  double probability = 0.999;
  double reacquire_after = 10.0;
  int reacquire_count = 5;
  double heading_support = 5.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled, {.doc = "reject what is too far from the estimate for chance"});
    v("probability", probability,
      {.min = 0.5, .max = 0.999999, .doc = "share of sound measurements that pass (chi-square)"});
    v("reacquire_after", reacquire_after,
      {.unit = "s",
       .min = 0,
       .max = 1000,
       .doc = "a source rejected for so long, in agreement with itself, takes the estimate over"});
    v("reacquire_count", reacquire_count,
      {.min = 2, .max = 1000, .doc = "rejections that this takes at least"});
    v("heading_support", heading_support,
      {.unit = "m",
       .min = 0,
       .max = 1000,
       .doc = "after so long a way with positions accepted, a compass cannot take the heading over"});
  }
};

struct AdaptiveOptions {
  bool enabled = false;
  double floor = 1.0;
  double ceiling = 100.0;
  double memory = 50.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled, {.doc = "learn from innovations how much noisier a source is than it declares"});
    v("floor", floor, {.min = 0.01, .max = 1, .doc = "least factor on a declared variance"});
    v("ceiling", ceiling, {.min = 1, .max = 1e4, .doc = "largest factor on a declared variance"});
    v("memory", memory, {.min = 10, .max = 1e4, .doc = "measurements that the factor looks back on"});
  }
};

struct SlipOptions {
  bool enabled = true;
  double window = 0.25;
  double gate = 25.0;
  double least_rate = 0.1;
  double hold = 0.3;
  double longest = 5.0;
  double distance_share = 0.05;
  double turn_share = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled, {.doc = "compare the turn of the wheels with the gyro"});
    v("window", window, {.unit = "s", .min = 0.01, .max = 10, .doc = "memory of the comparison"});
    v("gate", gate, {.min = 1, .max = 1000, .doc = "squared standard deviations of disagreement for slip"});
    v("least_rate", least_rate,
      {.unit = "rad/s", .min = 0, .max = 10, .doc = "smaller disagreements are never slip"});
    v("hold", hold,
      {.unit = "s", .min = 0, .max = 10, .doc = "slip lasts so long after the last sign of it"});
    v("longest", longest,
      {.unit = "s",
       .min = 0.1,
       .max = 1000,
       .doc = "more slip within half a minute is a fault: then the gyro is not used either"});
    v("distance_share", distance_share,
      {.min = 0,
       .max = 10,
       .doc = "standard deviation of what is left of the way during slip, as a share of it"});
    v("turn_share", turn_share,
      {.min = 0,
       .max = 10,
       .doc =
           "the same of the turn, as a share of what wheels and gyro disagree about: the gyro may be wrong"});
  }
};

struct InitialOptions {
  int headings = 5;
  int fixes = 3;
  double distance = 2.0;
  double heading_sigma = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    v("headings", headings, {.min = 1, .max = 32, .doc = "compass readings that agree, for a first heading"});
    v("fixes", fixes, {.min = 1, .max = 32, .doc = "positions that agree, for a first position"});
    v("distance", distance,
      {.unit = "m", .min = 0.1, .max = 100, .doc = "way between fixes for a heading without compass"});
    v("heading_sigma", heading_sigma,
      {.unit = "rad", .min = 0.01, .max = 1, .doc = "a heading from fixes must be known this well"});
  }
};

struct HealthOptions {
  double source_timeout = 1.0;
  double lost_two_sigma = 2.0;
  double degraded_two_sigma = 1.0;
  double lost_heading_sigma = 0.8;
  double lost_rejection = 3.0;
  double report_jump = 5.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("source_timeout", source_timeout,
      {.unit = "s", .min = 0.05, .max = 100, .doc = "silence of a source, at least 2.5 of its own periods"});
    v("lost_two_sigma", lost_two_sigma,
      {.unit = "m", .min = 0.01, .max = 1000, .doc = "LOST when two standard deviations exceed it"});
    v("degraded_two_sigma", degraded_two_sigma,
      {.unit = "m", .min = 0.01, .max = 1000, .doc = "DEGRADED when two standard deviations exceed it"});
    v("lost_heading_sigma", lost_heading_sigma,
      {.unit = "rad", .min = 0.01, .max = 3.15, .doc = "LOST when the heading is known worse"});
    v("lost_rejection", lost_rejection,
      {.unit = "s",
       .min = 0.1,
       .max = 1000,
       .doc = "LOST when no position passed the gate for so long while positions came"});
    v("report_jump", report_jump,
      {.unit = "s", .min = 0, .max = 100, .doc = "DEGRADED so long after a jump of clock or estimate"});
  }
};

struct EkfOptions {
  MeasurementLimits limits;
  BiasOptions bias;
  MotionOptions motion;
  GateOptions gate;
  AdaptiveOptions adaptive;
  SlipOptions slip;
  InitialOptions initial;
  HealthOptions health;
  double window = 2.0;
  int capacity = 2048;
  double course_speed = 0.3;
  double future_tolerance = 0.1;
  std::string on_clock_jump = "hold";

  template <class Visitor>
  void fields(Visitor& v) {
    v("limits", limits, {.doc = "what no sensor can mean"});
    v("bias", bias, {.doc = "errors of sensors that are estimated"});
    v("motion", motion, {.doc = "between and without wheel steps"});
    v("gate", gate, {.doc = "outliers, and when they are none"});
    v("adaptive", adaptive, {.doc = "noise of sources that declare too little"});
    v("slip", slip, {.doc = "wheels that slip"});
    v("initial", initial, {.doc = "the first pose"});
    v("health", health, {.doc = "OK, DEGRADED, LOST"});
    v("window", window,
      {.unit = "s", .min = 0, .max = 10, .doc = "late measurements are used if not older than this"});
    v("capacity", capacity, {.min = 16, .max = 65536, .doc = "measurements kept for that at most"});
    v("course_speed", course_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 10,
       .doc = "slower, the course over ground says nothing of the heading"});
    v("future_tolerance", future_tolerance,
      {.unit = "s", .min = 0, .max = 10, .doc = "stamps may be so far ahead of now"});
    v("on_clock_jump", on_clock_jump,
      {.choices = {"hold", "reset"},
       .doc = "hold: keep the pose, less sure, and go on from the new time; reset: find a new first pose"});
  }

  std::optional<std::string> violated_rule() const {
    if (health.lost_two_sigma < health.degraded_two_sigma)
      return "health.lost_two_sigma must be at least health.degraded_two_sigma";
    if (slip.longest <= slip.window + slip.hold)
      return "slip.longest must exceed slip.window + slip.hold, or every slip is a fault";
    if (gate.enabled && gate.reacquire_after < health.lost_rejection)
      return "gate.reacquire_after must be at least health.lost_rejection, or LOST is never told";
    if (motion.gyro_gap > motion.extrapolation && motion.extrapolation > 0.0)
      return "motion.gyro_gap must not exceed motion.extrapolation";
    return std::nullopt;
  }
};

}  // namespace bw::localization
