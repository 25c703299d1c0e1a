// Parameters of the EKF. Defaults suit a small indoor or campus robot with encoders, gyro, compass, receiver.
#pragma once

#include <optional>
#include <string>

#include "components/localization/measurement_check.hpp"
#include "runtime/base/choice.hpp"
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
    v("gyro_bias", gyro_bias, {.doc = "estimate the gyro's bias; off for a gyro that is calibrated"});
    v("gyro_bias_sigma", gyro_bias_sigma,
      {.unit = "rad/s", .min = 0, .max = 1, .doc = "standard deviation of the bias at the start"});
    v("gyro_bias_walk", gyro_bias_walk,
      {.unit = "rad/s/sqrt(s)",
       .min = 0,
       .max = 1,
       .doc = "how fast the bias wanders; raise it for a gyro that warms up"});
    v("heading_offset", heading_offset,
      {.doc = "estimate a constant error of the compass; needs positions, and a robot that drives"});
    v("heading_offset_sigma", heading_offset_sigma,
      {.unit = "rad",
       .min = 0,
       .max = 3.15,
       .doc = "standard deviation of the offset at the start; 3.15 for a compass whose zero points "
              "anywhere"});
    v("heading_offset_walk", heading_offset_walk,
      {.unit = "rad/sqrt(s)",
       .min = 0,
       .max = 1,
       .doc = "how fast the offset wanders; raise it where iron disturbs the compass"});
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
      {.unit = "m/s^2",
       .min = 0,
       .max = 100,
       .doc = "standard deviation of the acceleration while the pose is extrapolated; raise it for a base "
              "that jerks"});
    v("turn_acceleration", turn_acceleration,
      {.unit = "rad/s^2",
       .min = 0,
       .max = 100,
       .doc = "standard deviation of the angular acceleration while the pose is extrapolated"});
    v("silent_speed", silent_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 100,
       .doc = "standard deviation of the speed while wheels are silent"});
    v("silent_turn_rate", silent_turn_rate,
      {.unit = "rad/s",
       .min = 0,
       .max = 100,
       .doc = "standard deviation of the turn rate while wheels are silent and no gyro is heard"});
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
    v("enabled", enabled, {.doc = "reject measurements that are too far from the estimate for chance"});
    v("probability", probability,
      {.min = 0.5,
       .max = 0.999999,
       .doc = "share of sound measurements that pass the gate (chi-square); raise it when good fixes are "
              "rejected"});
    v("reacquire_after", reacquire_after,
      {.unit = "s",
       .min = 0,
       .max = 1000,
       .doc = "a source rejected for so long, in agreement with itself, takes the estimate over"});
    v("reacquire_count", reacquire_count,
      {.min = 2,
       .max = 1000,
       .doc = "how many rejections in a row it takes at least until a source takes the estimate over"});
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
    v("floor", floor, {.min = 0.01, .max = 1, .doc = "least factor on a variance that a source declares"});
    v("ceiling", ceiling,
      {.min = 1, .max = 1e4, .doc = "largest factor on a variance that a source declares"});
    v("memory", memory,
      {.min = 10,
       .max = 1e4,
       .doc = "over how many measurements the factor is learnt; fewer follow faster and are less sure"});
  }
};

struct SlipOptions {
  bool enabled = true;
  double window = 0.25;
  double gate = 25.0;
  /// [rad/s] smaller disagreements are never slip
  static constexpr double kLeastRate = 0.1;
  double hold = 0.3;
  double longest = 5.0;
  /// standard deviation of what is left of the way during slip, as a share of it
  static constexpr double kDistanceShare = 0.05;
  /// the same of the turn, as a share of what wheels and gyro disagree about: the gyro may be wrong
  static constexpr double kTurnShare = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    v("enabled", enabled, {.doc = "find slipping wheels by comparing their turn with the gyro"});
    v("window", window,
      {.unit = "s",
       .min = 0.01,
       .max = 10,
       .doc = "how long the comparison of wheels and gyro looks back; longer finds weaker slip, later"});
    v("gate", gate,
      {.min = 1,
       .max = 1000,
       .doc = "disagreement of wheels and gyro, in squared standard deviations, that is slip; lower finds "
              "weaker slip and false ones"});
    v("hold", hold,
      {.unit = "s", .min = 0, .max = 10, .doc = "slip lasts so long after the last sign of it"});
    v("longest", longest,
      {.unit = "s",
       .min = 0.1,
       .max = 1000,
       .doc = "more slip within half a minute is a fault: then the gyro is not used either"});
  }
};

struct InitialOptions {
  int headings = 5;
  int fixes = 3;
  double distance = 2.0;
  double heading_sigma = 0.2;

  template <class Visitor>
  void fields(Visitor& v) {
    v("headings", headings,
      {.min = 1, .max = 32, .doc = "how many compass readings must agree for a first heading"});
    v("fixes", fixes, {.min = 1, .max = 32, .doc = "how many positions must agree for a first position"});
    v("distance", distance,
      {.unit = "m",
       .min = 0.1,
       .max = 100,
       .doc = "length of the way between fixes that gives a first heading without a compass"});
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
      {.unit = "s",
       .min = 0.05,
       .max = 100,
       .doc = "a source that is silent for longer (and 2.5 of its own periods) makes the state DEGRADED"});
    v("lost_two_sigma", lost_two_sigma,
      {.unit = "m",
       .min = 0.01,
       .max = 1000,
       .doc = "LOST when two standard deviations of the position exceed this; with it the robot stops"});
    v("degraded_two_sigma", degraded_two_sigma,
      {.unit = "m",
       .min = 0.01,
       .max = 1000,
       .doc = "DEGRADED when two standard deviations of the position exceed this"});
    v("lost_heading_sigma", lost_heading_sigma,
      {.unit = "rad",
       .min = 0.01,
       .max = 3.15,
       .doc = "LOST when the standard deviation of the heading exceeds this"});
    v("lost_rejection", lost_rejection,
      {.unit = "s",
       .min = 0.1,
       .max = 1000,
       .doc = "LOST when no position passed the gate for so long while positions came"});
    v("report_jump", report_jump,
      {.unit = "s", .min = 0, .max = 100, .doc = "DEGRADED so long after a jump of clock or estimate"});
  }
};

enum class OnClockJump { hold, reset };
constexpr auto choice_table(OnClockJump) {
  return choices<OnClockJump>({{OnClockJump::hold, "hold"}, {OnClockJump::reset, "reset"}});
}

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
  OnClockJump on_clock_jump = OnClockJump::hold;

  template <class Visitor>
  void fields(Visitor& v) {
    v("limits", limits, {.doc = "what no sensor can mean"});
    v("bias", bias, {.doc = "errors of sensors that the filter estimates"});
    v("motion", motion, {.doc = "how the pose moves between and without wheel steps"});
    v("gate", gate,
      {.doc = "which measurements are outliers, and when a rejected source is believed after all"});
    v("adaptive", adaptive, {.doc = "learning how noisy sources are that declare too little"});
    v("slip", slip, {.doc = "finding wheels that slip"});
    v("initial", initial, {.doc = "how the first pose is found"});
    v("health", health, {.doc = "when the state is OK, DEGRADED, LOST"});
    v("window", window,
      {.unit = "s", .min = 0, .max = 10, .doc = "late measurements are used if not older than this"});
    v("capacity", capacity,
      {.min = 16,
       .max = 65536,
       .doc = "how many measurements are kept for late ones; fewer shorten the window"});
    v("course_speed", course_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 10,
       .doc = "below this speed the course over ground says nothing of the heading"});
    v("future_tolerance", future_tolerance,
      {.unit = "s",
       .min = 0,
       .max = 10,
       .doc = "how far ahead of now a stamp may be; raise it for sensors whose clock runs ahead"});
    v("on_clock_jump", on_clock_jump,
      {.doc = "hold: keep the pose, less sure, and go on from the new time; reset: find a new first pose"});
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
