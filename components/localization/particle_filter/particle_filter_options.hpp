// Parameters of the particle filter. Names as in AMCL where it has one.
#pragma once

#include <optional>
#include <string>

#include "components/localization/ekf/ekf_options.hpp"
#include "components/localization/laser/likelihood_field_options.hpp"
#include "components/localization/laser/pose_search_options.hpp"
#include "components/localization/measurement_check.hpp"
#include "components/localization/particle_filter/recovery_options.hpp"
#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::localization {

struct ParticleCountOptions {
  int min_particles = 500;
  int max_particles = 2000;
  /// how far the set may be from the true distribution (Kullback-Leibler)
  static constexpr double kPfErr = 0.05;
  /// normal quantile of keeping to pf_err: 0.99 means in 84 % of all cases
  static constexpr double kPfZ = 0.99;

  template <class Visitor>
  void fields(Visitor& v) {
    v("min_particles", min_particles,
      {.min = 10, .max = 50000, .doc = "fewest particles; raise it when the pose wavers"});
    v("max_particles", max_particles,
      {.min = 10, .max = 50000, .doc = "most particles; raise it for large maps without a known start"});
    v.retired({"pf_z"}, "a constant of particle_filter_options.hpp");
  }
  std::optional<std::string> violated_rule() const {
    if (min_particles <= max_particles) return std::nullopt;
    return "min_particles must not exceed max_particles";
  }
};

/// Where the noise of the motion comes from (noise below).
enum class MotionNoise { declared, amcl, both, per_step };
constexpr auto choice_table(MotionNoise) {
  using enum MotionNoise;
  return choices<MotionNoise>(
      {{declared, "declared"}, {amcl, "amcl"}, {both, "both"}, {per_step, "per_step"}});
}

struct ParticleMotionOptions {
  MotionNoise noise = MotionNoise::declared;
  double alpha1 = 0.2;
  double alpha2 = 0.2;
  double alpha3 = 0.2;
  double alpha4 = 0.2;
  /// [m] noise per_step: standard deviation along the way
  static constexpr double kStepAlong = 0.04;
  /// [m] noise per_step: standard deviation across the way
  static constexpr double kStepAcross = 0.012;
  /// [rad] noise per_step: standard deviation of the heading
  static constexpr double kStepHeading = 0.0061;
  /// [m/sqrt(s)] spread of the position that is added to any motion, since a set that rests dies out (set by
  /// code alone)
  double walk = 0.005;
  /// [rad/sqrt(s)] spread of the heading that is added to any motion (set by code alone)
  double heading_walk = 0.002;
  /// [rad/s] standard deviation of what is left of the gyro bias after standing still (set by code alone)
  double gyro_bias_sigma = 0.002;
  /// [s] gyro readings further apart are not integrated
  static constexpr double kGyroGap = 0.1;
  /// [m] particles move at the latest after so long a way; 0: every step (set by code alone)
  double longest_distance = 0.25;
  /// [rad] particles move at the latest after so large a turn; 0: every step
  static constexpr double kLongestRotation = 0.2;
  /// [s] after the last wheel step the velocity holds this long; then the motion is unknown
  static constexpr double kExtrapolation = 0.5;
  /// [m/s] standard deviation of the speed while wheels are silent
  static constexpr double kSilentSpeed = 1.0;
  /// [rad/s] standard deviation of the turn rate while wheels are silent
  static constexpr double kSilentTurnRate = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("noise", noise,
      {.doc = "declared: the covariance of each wheel step; amcl: alpha1 to alpha4 on the way between two "
              "updates; both: their sum; per_step: step_along, step_across, step_heading for every step"});
    v("alpha1", alpha1, {.min = 0, .max = 10, .doc = "noise of the turn by the turn, rad^2/rad^2"});
    v("alpha2", alpha2, {.min = 0, .max = 10, .doc = "noise of the turn by the way, rad^2/m^2"});
    v("alpha3", alpha3, {.min = 0, .max = 10, .doc = "noise of the way by the way, m^2/m^2"});
    v("alpha4", alpha4, {.min = 0, .max = 10, .doc = "noise of the way by the turn, m^2/rad^2"});
    v.retired(
        {"step_along", "step_across", "step_heading", "extrapolation", "silent_speed", "silent_turn_rate"},
        "a constant of particle_filter_options.hpp");
  }
};

struct ResamplingOptions {
  /// particles are drawn anew when fewer than this share count; 1: after every measurement (set by code
  /// alone)
  double n_eff_share = 0.5;
  /// fewest measurements between two drawings
  static constexpr int kResampleInterval = 1;
};

struct LaserUseOptions {
  double update_min_d = 0.25;
  double update_min_a = 0.2;
  int max_beams = 60;

  template <class Visitor>
  void fields(Visitor& v) {
    v("update_min_d", update_min_d,
      {.unit = "m", .min = 0, .max = 10, .doc = "a sweep is used after so long a way; 0: every sweep"});
    v("update_min_a", update_min_a,
      {.unit = "rad", .min = 0, .max = 3, .doc = "a sweep is used after so large a turn; 0: every sweep"});
    v("max_beams", max_beams,
      {.min = 3,
       .max = 10000,
       .doc = "how many beams of a sweep are compared with the map; the time of an update grows with it"});
  }
};

struct ParticleHealthOptions {
  /// DEGRADED when the heaviest group of particles holds less
  static constexpr double kSeveralPlaces = 0.9;
  /// LOST when the heaviest group of particles holds less
  static constexpr double kLostSeveralPlaces = 0.5;
};

/// What the errors of a particle make of its weight (weight_law below).
enum class WeightLaw { gaussian, printed, printed_unscaled };
constexpr auto choice_table(WeightLaw) {
  using enum WeightLaw;
  return choices<WeightLaw>(
      {{gaussian, "gaussian"}, {printed, "printed"}, {printed_unscaled, "printed_unscaled"}});
}

struct ParticleFilterOptions {
  MeasurementLimits limits;
  ParticleCountOptions count;
  ParticleMotionOptions motion;
  /// gaussian: exp(-d^2/2) of the errors in standard deviations; printed: exp(-d^0.4/2), as in the
  /// dissertation; printed_unscaled: the same of metres and radians as they are (set by code alone)
  WeightLaw weight_law = WeightLaw::gaussian;
  ResamplingOptions resampling;
  LaserUseOptions laser;
  LikelihoodFieldOptions field;
  PoseSearchOptions search;
  RecoveryOptions recovery;
  /// which measurements are outliers, and when a rejected source is believed after all (set by code alone)
  GateOptions gate;
  InitialOptions initial;
  HealthOptions health;
  ParticleHealthOptions particle_health;
  /// [s] late measurements are used if not older than this
  static constexpr double kWindow = 2.0;
  /// [m/s] below this speed the course over ground says nothing of the heading
  static constexpr double kCourseSpeed = 0.3;
  /// [s] how far ahead of now a stamp may be
  static constexpr double kFutureTolerance = 0.1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("count", count, {.doc = "how many particles"});
    v("motion", motion, {.doc = "how particles move"});
    v("laser", laser, {.doc = "which sweeps and beams count"});
    v("field", field, {.doc = "what a beam says of a place"});
    v("recovery", recovery, {.doc = "when to search, and what to do with what was found"});
    v("health", health, {.doc = "when the state is OK, DEGRADED, LOST"});
    v.retired({"limits", "weight_law", "resampling", "initial", "particle_health", "course_speed", "search",
               "gate", "window", "future_tolerance"},
              "a constant of particle_filter_options.hpp");
  }
};

}  // namespace bw::localization
