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
  double pf_err = 0.05;
  double pf_z = 0.99;

  template <class Visitor>
  void fields(Visitor& v) {
    v("min_particles", min_particles,
      {.min = 10, .max = 50000, .doc = "fewest particles; raise it when the pose wavers"});
    v("max_particles", max_particles,
      {.min = 10, .max = 50000, .doc = "most particles; raise it for large maps without a known start"});
    v("pf_err", pf_err,
      {.min = 0.001,
       .max = 1,
       .doc = "how far the set may be from the true distribution (Kullback-Leibler); lower takes more "
              "particles"});
    v("pf_z", pf_z,
      {.min = 0, .max = 10, .doc = "normal quantile of keeping to pf_err: 0.99 means in 84 % of all cases"});
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
  double step_along = 0.04;
  double step_across = 0.012;
  double step_heading = 0.0061;
  double walk = 0.005;
  double heading_walk = 0.002;
  double gyro_bias_sigma = 0.002;
  double gyro_gap = 0.1;
  double longest_way = 0.25;
  double longest_turn = 0.2;
  double extrapolation = 0.5;
  double silent_speed = 1.0;
  double silent_turn_rate = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("noise", noise,
      {.doc = "declared: the covariance of each wheel step; amcl: alpha1 to alpha4 on the way between two "
              "updates; both: their sum; per_step: step_along, step_across, step_heading for every step"});
    v("alpha1", alpha1, {.min = 0, .max = 10, .doc = "noise of the turn by the turn, rad^2/rad^2"});
    v("alpha2", alpha2, {.min = 0, .max = 10, .doc = "noise of the turn by the way, rad^2/m^2"});
    v("alpha3", alpha3, {.min = 0, .max = 10, .doc = "noise of the way by the way, m^2/m^2"});
    v("alpha4", alpha4, {.min = 0, .max = 10, .doc = "noise of the way by the turn, m^2/rad^2"});
    v("step_along", step_along,
      {.unit = "m", .min = 0, .max = 10, .doc = "noise per_step: standard deviation along the way"});
    v("step_across", step_across,
      {.unit = "m", .min = 0, .max = 10, .doc = "noise per_step: standard deviation across the way"});
    v("step_heading", step_heading,
      {.unit = "rad", .min = 0, .max = 3, .doc = "noise per_step: standard deviation of the heading"});
    v("walk", walk,
      {.unit = "m/sqrt(s)",
       .min = 0,
       .max = 1,
       .doc = "spread of the position that is added to any motion, since a set that rests dies out"});
    v("heading_walk", heading_walk,
      {.unit = "rad/sqrt(s)",
       .min = 0,
       .max = 1,
       .doc = "spread of the heading that is added to any motion"});
    v("gyro_bias_sigma", gyro_bias_sigma,
      {.unit = "rad/s",
       .min = 0,
       .max = 1,
       .doc = "standard deviation of what is left of the gyro bias after standing still"});
    v("gyro_gap", gyro_gap,
      {.unit = "s", .min = 0.001, .max = 1, .doc = "gyro readings further apart are not integrated"});
    v("longest_way", longest_way,
      {.unit = "m",
       .min = 0,
       .max = 2,
       .doc = "particles move at the latest after so long a way; 0: every step"});
    v("longest_turn", longest_turn,
      {.unit = "rad",
       .min = 0,
       .max = 1,
       .doc = "particles move at the latest after so large a turn; 0: every step"});
    v("extrapolation", extrapolation,
      {.unit = "s",
       .min = 0,
       .max = 2,
       .doc = "after the last wheel step the velocity holds this long; then the motion is unknown"});
    v("silent_speed", silent_speed,
      {.unit = "m/s",
       .min = 0,
       .max = 100,
       .doc = "standard deviation of the speed while wheels are silent"});
    v("silent_turn_rate", silent_turn_rate,
      {.unit = "rad/s",
       .min = 0,
       .max = 100,
       .doc = "standard deviation of the turn rate while wheels are silent"});
  }
};

struct ResamplingOptions {
  double n_eff_share = 0.5;
  int resample_interval = 1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("n_eff_share", n_eff_share,
      {.min = 0,
       .max = 1,
       .doc = "particles are drawn anew when fewer than this share count; 1: after every measurement"});
    v("resample_interval", resample_interval,
      {.min = 1, .max = 100, .doc = "fewest measurements between two drawings"});
  }
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
  double several_places = 0.9;
  double lost_several_places = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    v("several_places", several_places,
      {.min = 0, .max = 1, .doc = "DEGRADED when the heaviest group of particles holds less"});
    v("lost_several_places", lost_several_places,
      {.min = 0, .max = 1, .doc = "LOST when the heaviest group of particles holds less"});
  }
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
  WeightLaw weight_law = WeightLaw::gaussian;
  ResamplingOptions resampling;
  LaserUseOptions laser;
  LikelihoodFieldOptions field;
  PoseSearchOptions search;
  RecoveryOptions recovery;
  GateOptions gate;
  InitialOptions initial;
  HealthOptions health;
  ParticleHealthOptions particle_health;
  double window = 2.0;
  double course_speed = 0.3;
  double future_tolerance = 0.1;

  template <class Visitor>
  void fields(Visitor& v) {
    v("limits", limits, {.doc = "what no sensor can mean"});
    v("count", count, {.doc = "how many particles"});
    v("motion", motion, {.doc = "how particles move"});
    v("weight_law", weight_law,
      {.doc = "gaussian: exp(-d^2/2) of the errors in standard deviations; printed: exp(-d^0.4/2), as in the "
              "dissertation; printed_unscaled: the same of metres and radians as they are"});
    v("resampling", resampling, {.doc = "when particles are drawn anew"});
    v("laser", laser, {.doc = "which sweeps and beams count"});
    v("field", field, {.doc = "what a beam says of a place"});
    v("search", search, {.doc = "the search over the whole map"});
    v("recovery", recovery, {.doc = "when to search, and what to do with what was found"});
    v("gate", gate,
      {.doc = "which measurements are outliers, and when a rejected source is believed after all"});
    v("initial", initial, {.doc = "how the first pose is found from measurements"});
    v("health", health, {.doc = "when the state is OK, DEGRADED, LOST"});
    v("particle_health", particle_health,
      {.doc = "when groups of particles make the state DEGRADED or LOST"});
    v("window", window,
      {.unit = "s", .min = 0, .max = 10, .doc = "late measurements are used if not older than this"});
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
  }
};

}  // namespace bw::localization
