// Parameters of MPPI (theory.md 5.8), named and preset as in the parameter file that Nav2 ships (Jazzy).
// Speeds and accelerations are the robot's (PlanningProblem::limits).
#pragma once

#include <cstdint>

#include "components/local_planner/mppi/critic_options.hpp"
#include "runtime/base/field.hpp"

namespace bw::mppi {

/// What each pose costs by its distance to the nearest obstacle, as Nav2's inflation layer has it.
struct InflationOptions {
  double inflation_radius = 0.7;
  /// [1/m] how fast the cost falls with the distance
  static constexpr double kCostScalingFactor = 3.0;

  template <class Visitor>
  void fields(Visitor& v) {
    v("inflation_radius", inflation_radius,
      {.unit = "m",
       .min = 0,
       .max = 5,
       .doc = "places nearer than this to an obstacle cost; raise it to keep further away"});
    v.retired({"cost_scaling_factor"}, "a constant of mppi_options.hpp");
  }
};

struct MppiOptions {
  std::int64_t batch_size = 2000;
  std::int64_t time_steps = 56;
  double model_dt = 0.05;
  double vx_std = 0.2;
  double wz_std = 0.4;
  bool predict_movers = false;
  bool check_motion = false;
  InflationOptions inflation;
  ConstraintOptions constraint;
  CostOptions cost;
  GoalOptions goal;
  GoalAngleOptions goal_angle;
  PathAlignOptions path_align;
  PathFollowOptions path_follow;
  PathAngleOptions path_angle;
  PreferForwardOptions prefer_forward;

  /// cost of leaving the motion of the last cycle
  static constexpr double kGamma = 0.015;

  // Set by code.
  double temperature = 0.3;  ///< difference of cost that a weight falls by a factor of e for
  /// The mean is taken of what the accelerations leave of the samples, as in Jazzy; else of the samples, as
  /// in Lyrical, which speeds up and turns in sooner where accelerations are low.
  bool clamp_raw_controls = true;
  bool regenerate_noises = true;  ///< other samples in every cycle; else the same ones, which costs less time
  std::uint64_t seed = 1;         ///< of the samples

  template <class Visitor>
  void fields(Visitor& v) {
    v("batch_size", batch_size,
      {.min = 2, .max = 20000, .doc = "sampled motions; the time of a cycle grows with it"});
    v("time_steps", time_steps,
      {.min = 2, .max = 400, .doc = "steps of a motion; more look further ahead and cost time"});
    v("model_dt", model_dt,
      {.unit = "s",
       .min = 0.01,
       .max = 1,
       .doc = "length of a step; longer looks further ahead, and less exactly"});
    v("vx_std", vx_std,
      {.unit = "m/s",
       .min = 0.001,
       .max = 10,
       .doc = "spread of the sampled speeds; raise it for bolder motions"});
    v("wz_std", wz_std,
      {.unit = "rad/s",
       .min = 0.001,
       .max = 20,
       .doc = "spread of the sampled turn rates; raise it for tighter turns"});
    v("predict_movers", predict_movers,
      {.doc = "people where they will be at the time of each pose; false: as shipped, where they are now"});
    v("check_motion", check_motion,
      {.doc =
           "a motion that is not free or passes people too closely is left for an evasive move, as by the other "
           "planners; false: as shipped, only when every sample collides, and then it stops"});
    v("inflation", inflation, {.doc = "the costmap"});
    v("cost", cost, {.doc = "critic of the costmap"});
    v("path_align", path_align, {.doc = "critic of the distance to the plan"});
    v("path_follow", path_follow, {.doc = "critic of progress along the plan"});
    v.retired({"temperature", "gamma", "clamp_raw_controls", "constraint", "goal", "goal_angle", "path_angle",
               "prefer_forward"},
              "set by code alone, in mppi_options.hpp");
  }
};

}  // namespace bw::mppi
