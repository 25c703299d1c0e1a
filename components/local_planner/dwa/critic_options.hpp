// Parameters of the profile `critics` (theory.md 5.9): what DWB's users know, under DWB's names where it has
// them.
#pragma once

#include <cstdint>

#include "runtime/base/field.hpp"

namespace bw::dwa {

/// How far before the robot the point is that the aligning terms look at [m]: DWB's forward_point_distance.
inline constexpr double kForwardPoint = 0.325;
/// Gaps from here on cost nothing [m], and how fast the cost falls with the gap [1/m]: those of Nav2's
/// inflation layer.
inline constexpr double kInflationRadius = 0.55;
inline constexpr double kCostScaling = 3.0;
/// What tells equals apart: the faster [s/m], and who turns as now [s/rad].
inline constexpr double kSpeedScale = 1.0;
inline constexpr double kTurnRateChangeScale = 0.5;

struct CriticOptions {
  double path_dist_scale = 32.0;
  double path_align_scale = 32.0;
  double goal_dist_scale = 24.0;
  double goal_align_scale = 24.0;
  double base_obstacle_scale = 10.0;
  double sim_time = 1.7;
  std::int64_t vx_samples = 20;
  std::int64_t vtheta_samples = 20;
  /// [m] gap of the footprint that counts as contact
  static constexpr double kMargin = 0.05;
  /// [rad] the robot turns on the spot when the plan leads off by more than this
  static constexpr double kRotateThreshold = 1.0;

  template <class Visitor>
  void fields(Visitor& v) {
    scale_fields(v);
    sample_fields(v);
    v.retired({"margin", "rotate_threshold"}, "a constant of critic_options.hpp");
  }

 private:
  template <class Visitor>
  void scale_fields(Visitor& v) {
    v("path_dist_scale", path_dist_scale,
      {.unit = "1/m",
       .min = 0,
       .max = 1000,
       .doc = "cost per metre between the plan and where a sample ends; raise it to keep to the plan"});
    v("path_align_scale", path_align_scale,
      {.unit = "1/m",
       .min = 0,
       .max = 1000,
       .doc = "the same of a point before the robot: raise it to keep its heading along the plan"});
    v("goal_dist_scale", goal_dist_scale,
      {.unit = "1/m",
       .min = 0,
       .max = 1000,
       .doc =
           "cost per metre of the plan that is left where a sample ends; raise it for a robot that dawdles"});
    v("goal_align_scale", goal_align_scale,
      {.unit = "1/m",
       .min = 0,
       .max = 1000,
       .doc = "the same of a point before the robot: raise it to turn into bends sooner"});
    v("base_obstacle_scale", base_obstacle_scale,
      {.min = 0,
       .max = 1000,
       .doc = "cost of touching, which falls with the gap; raise it to pass obstacles more widely"});
  }
  template <class Visitor>
  void sample_fields(Visitor& v) {
    v("sim_time", sim_time,
      {.unit = "s", .min = 0.1, .max = 20, .doc = "length of a roll-out; longer sees more and turns later"});
    v("vx_samples", vx_samples,
      {.min = 2, .max = 201, .doc = "how many speeds are tried; the time of a cycle grows with it"});
    v("vtheta_samples", vtheta_samples,
      {.min = 2,
       .max = 201,
       .doc = "how many turn rates are tried for each speed; the time of a cycle grows with it"});
  }
};

}  // namespace bw::dwa
