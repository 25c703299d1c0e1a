// Parameters of the EKF. Defaults suit a small indoor or campus robot with encoders, gyro, compass, receiver.
#pragma once

#include <optional>
#include <string>

#include "components/localization/measurement_check.hpp"
#include "runtime/base/field.hpp"

namespace bw::localization {

struct BiasOptions {
  bool gyro_bias = true;
  /// [rad/s] standard deviation of the bias at the start (set by code alone)
  double gyro_bias_sigma = 0.02;
  /// [rad/s/sqrt(s)] how fast the bias wanders (set by code alone)
  double gyro_bias_walk = 1e-4;
  bool heading_offset = false;
  /// [rad] standard deviation of the offset at the start; 3.15 for a compass whose zero points anywhere (set
  /// by code alone)
  double heading_offset_sigma = 0.3;
  /// [rad/sqrt(s)] how fast the offset wanders (set by code alone)
  double heading_offset_walk = 0.005;

  template <class Visitor>
  void fields(Visitor& v) {
    v("gyro_bias", gyro_bias, {.doc = "estimate the gyro's bias; off for a gyro that is calibrated"});
    v("heading_offset", heading_offset,
      {.doc = "estimate a constant error of the compass; needs positions, and a robot that drives"});
  }
};

struct MotionOptions {
  /// [s] after the last wheel step the velocity holds this long; then the motion is unknown (set by code
  /// alone)
  double extrapolation = 0.5;
  double acceleration = 1.0;
  /// [rad/s^2] standard deviation of the angular acceleration while the pose is extrapolated
  static constexpr double kAngularAcceleration = 1.0;
  /// [m/s] standard deviation of the speed while wheels are silent
  static constexpr double kSilentSpeed = 1.0;
  /// [rad/s] standard deviation of the turn rate while wheels are silent and no gyro is heard
  static constexpr double kSilentTurnRate = 1.0;
  /// [s] gyro readings further apart are not integrated
  static constexpr double kGyroGap = 0.1;
  double position_walk = 0.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("acceleration", acceleration,
      {.unit = "m/s^2",
       .min = 0,
       .max = 100,
       .doc = "standard deviation of the acceleration while the pose is extrapolated; raise it for a base "
              "that jerks"});
    v("position_walk", position_walk,
      {.unit = "m/sqrt(m)",
       .min = 0,
       .max = 10,
       .doc =
           "how fast position and fixes drift apart on the way by what neither declares: skidding sideways, "
           "a receiver whose error wanders; without it such drift is taken for turns"});
    v.retired({"silent_speed", "silent_turn_rate", "extrapolation"}, "a constant of ekf_options.hpp");
  }
};

struct GateOptions {
  /// measurements that are too far from the estimate for chance are rejected (set by code alone)
  bool enabled = true;
  double probability = 0.999;
  /// [s] a source rejected for so long, in agreement with itself, takes the estimate over (set by code alone)
  double reacquire_after = 10.0;
  /// how many rejections in a row it takes at least until a source takes the estimate over
  static constexpr int kReacquireCount = 5;
  /// [m] after so long a way with positions accepted, a compass cannot take the heading over
  static constexpr double kHeadingSupport = 5.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("probability", probability,
      {.min = 0.5,
       .max = 0.999999,
       .doc = "share of sound measurements that pass the gate (chi-square); raise it when good fixes are "
              "rejected"});
    v.retired({"enabled", "reacquire_after"}, "set by code alone, in ekf_options.hpp");
  }
};

struct AdaptiveOptions {
  /// learn from innovations how much noisier a source is than it declares (set by code alone)
  bool enabled = false;
  /// least factor on a variance that a source declares
  static constexpr double kFloor = 1.0;
  /// largest factor on a variance that a source declares
  static constexpr double kCeiling = 100.0;
  /// over how many measurements the factor is learnt
  static constexpr double kMemory = 50.0;
};

struct SlipOptions {
  /// find slipping wheels by comparing their turn with the gyro (set by code alone)
  bool enabled = true;
  /// [s] how long the comparison of wheels and gyro looks back
  static constexpr double kWindow = 0.25;
  /// disagreement of wheels and gyro, in squared standard deviations, that is slip
  static constexpr double kGate = 25.0;
  /// [rad/s] smaller disagreements are never slip
  static constexpr double kLeastRate = 0.1;
  /// [s] slip lasts so long after the last sign of it
  static constexpr double kHold = 0.3;
  /// [s] more slip within half a minute is a fault: then the gyro is not used either (set by code alone)
  double longest = 5.0;
  /// standard deviation of what is left of the way during slip, as a share of it
  static constexpr double kDistanceShare = 0.05;
  /// the same of the turn, as a share of what wheels and gyro disagree about: the gyro may be wrong
  static constexpr double kRotationShare = 0.2;
};

struct InitialOptions {
  /// how many compass readings must agree for a first heading
  static constexpr int kHeadings = 5;
  /// how many positions must agree for a first position
  static constexpr int kFixes = 3;
  /// [m] length of the way between fixes that gives a first heading without a compass (set by code alone)
  double distance = 2.0;
  /// [rad] a heading from fixes must be known this well (set by code alone)
  double heading_sigma = 0.2;
};

struct HealthOptions {
  /// [s] a source that is silent for longer, and for 2.5 of its own periods, makes the state DEGRADED
  static constexpr double kSourceTimeout = 1.0;
  double lost_two_sigma = 2.0;
  /// DEGRADED when two standard deviations of the position exceed this share of lost_two_sigma
  static constexpr double kDegradedShare = 0.5;
  /// [rad] LOST when the standard deviation of the heading exceeds this
  static constexpr double kLostHeadingSigma = 0.8;
  /// [s] LOST when no position passed the gate for so long while positions came
  static constexpr double kLostRejection = 3.0;
  /// [s] DEGRADED so long after a jump of clock or estimate
  static constexpr double kReportJump = 5.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("lost_two_sigma", lost_two_sigma,
      {.unit = "m",
       .min = 0.01,
       .max = 1000,
       .doc = "LOST when two standard deviations of the position exceed this, DEGRADED from half of it; with "
              "LOST the robot stops"});
    v.retired({"source_timeout", "degraded_two_sigma"}, "a constant of ekf_options.hpp");
  }
};

enum class OnClockJump { hold, reset };

struct EkfOptions {
  MeasurementLimits limits;
  BiasOptions bias;
  MotionOptions motion;
  GateOptions gate;
  AdaptiveOptions adaptive;
  SlipOptions slip;
  InitialOptions initial;
  HealthOptions health;
  /// [s] late measurements are used if not older than this
  static constexpr double kWindow = 2.0;
  /// how many measurements are kept for late ones (set by code alone)
  int capacity = 2048;
  /// [m/s] below this speed the course over ground says nothing of the heading
  static constexpr double kCourseSpeed = 0.3;
  /// [s] how far ahead of now a stamp may be
  static constexpr double kFutureTolerance = 0.1;
  /// hold: keep the pose, less sure, and go on from the new time; reset: find a new first pose (set by code
  /// alone)
  OnClockJump on_clock_jump = OnClockJump::hold;

  template <class Visitor>
  void fields(Visitor& v) {
    v("bias", bias, {.doc = "errors of sensors that the filter estimates"});
    v("motion", motion, {.doc = "how the pose moves between and without wheel steps"});
    v("gate", gate,
      {.doc = "which measurements are outliers, and when a rejected source is believed after all"});
    v("health", health, {.doc = "when the state is OK, DEGRADED, LOST"});
    v.retired({"limits", "initial", "course_speed", "adaptive", "slip", "window", "future_tolerance",
               "on_clock_jump"},
              "a constant of ekf_options.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (gate.enabled && gate.reacquire_after < HealthOptions::kLostRejection)
      return "gate.reacquire_after must be at least 3 s, or LOST is never told";
    if (MotionOptions::kGyroGap > motion.extrapolation && motion.extrapolation > 0.0)
      return "motion.extrapolation must be 0 or at least the 0.1 s over which the gyro is integrated";
    return std::nullopt;
  }
};

}  // namespace bw::localization
