// Parameters of the profile `critics` (book 5.9): what DWB's users know, under DWB's names where it has them.
#pragma once

#include <cstdint>

#include "runtime/base/field.hpp"

namespace bw::dwa {

struct CriticOptions {
  double path_dist_scale = 32.0;
  double path_align_scale = 32.0;
  double goal_dist_scale = 24.0;
  double goal_align_scale = 24.0;
  double forward_point_distance = 0.325;
  double base_obstacle_scale = 10.0;
  double cost_scaling_factor = 3.0;
  double inflation_radius = 0.55;
  double speed_scale = 1.0;
  double turn_change_scale = 0.5;
  double sim_time = 1.7;
  std::int64_t vx_samples = 20;
  std::int64_t vtheta_samples = 20;
  double margin = 0.05;
  double rotate_threshold = 1.0;
  double rotate_sampling_distance = 0.5;

  template <class Visitor>
  void fields(Visitor& v) {
    scale_fields(v);
    sample_fields(v);
    rotate_fields(v);
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
    v("forward_point_distance", forward_point_distance,
      {.unit = "m", .min = 0.01, .max = 5, .doc = "how far that point is before the robot"});
    v("base_obstacle_scale", base_obstacle_scale,
      {.min = 0,
       .max = 1000,
       .doc = "cost of touching, which falls with the gap; raise it to pass obstacles more widely"});
    v("cost_scaling_factor", cost_scaling_factor,
      {.unit = "1/m", .min = 0, .max = 100, .doc = "how fast that cost falls with the gap"});
    v("inflation_radius", inflation_radius,
      {.unit = "m", .min = 0.01, .max = 5, .doc = "gaps from here on cost nothing"});
    v("speed_scale", speed_scale,
      {.unit = "s/m", .min = 0, .max = 1000, .doc = "of samples that lead equally far, the faster one"});
    v("turn_change_scale", turn_change_scale,
      {.unit = "s/rad",
       .min = 0,
       .max = 1000,
       .doc = "cost of another turn rate than the present one; raise it for a robot that swings"});
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
    v("margin", margin,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc =
           "gap of the footprint that counts as contact; raise it where the robot drives less exactly than it plans"});
  }
  template <class Visitor>
  void rotate_fields(Visitor& v) {
    v("rotate_threshold", rotate_threshold,
      {.unit = "rad",
       .min = 0.1,
       .max = 3.15,
       .doc = "the robot turns on the spot when the plan leads off by more than this; 3.15: never"});
    v("rotate_sampling_distance", rotate_sampling_distance,
      {.unit = "m", .min = 0.05, .max = 10, .doc = "how far ahead it looks for where the plan leads"});
  }
};

}  // namespace bw::dwa
