// What a timed elastic band is asked to be: resolution, clearances and the weights of its cost. Names and
// meanings follow the public teb_local_planner package; defaults differ where noted. One set serves every
// candidate band.
#pragma once

#include <optional>
#include <string>

#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::teb {

/// Weights of the squared residuals (book 6.1). Limits are stiffer than the package's 2/1/1/1, so that plans
/// keep them.
struct BandWeights {
  double time = 1.0;
  double kinematics_nh = 1000.0;
  double forward_drive = 1.0;
  double max_vel_x = 40.0;
  double max_vel_theta = 20.0;
  double acc_lim_x = 10.0;
  double acc_lim_theta = 10.0;
  double obstacle = 50.0;
  double inflation = 0.1;
  double dynamic_obstacle = 50.0;
  double dynamic_inflation = 2.0;
  double possible_inflation = 0.02;

  template <class Visitor>
  void fields(Visitor& v) {
    v("time", time,
      {.min = 1e-6,
       .max = 1e4,
       .doc = "weight of the squared time intervals; raise it to drive faster and bolder"});
    v("kinematics_nh", kinematics_nh,
      {.min = 0,
       .max = 1e6,
       .doc = "weight of what keeps both poses of a segment on one arc; lower lets the band slide "
              "sideways"});
    v("forward_drive", forward_drive,
      {.min = 0, .max = 1e6, .doc = "weight of driving backward; raise it to forbid reversing"});
    v("max_vel_x", max_vel_x,
      {.min = 0,
       .max = 1e6,
       .doc = "weight of speed outside its limits; raise it when plans are faster than the robot"});
    v("max_vel_theta", max_vel_theta,
      {.min = 0, .max = 1e6, .doc = "weight of a turn rate outside its limits"});
    v("acc_lim_x", acc_lim_x,
      {.min = 0,
       .max = 1e6,
       .doc = "weight of a linear acceleration outside its limits; raise it when the robot cannot follow "
              "its plan"});
    v("acc_lim_theta", acc_lim_theta,
      {.min = 0, .max = 1e6, .doc = "weight of an angular acceleration outside its limits"});
    v("obstacle", obstacle,
      {.min = 0,
       .max = 1e6,
       .doc = "weight of being closer than min_obstacle_dist to a static obstacle; raise it when bands "
              "cut corners"});
    v("inflation", inflation,
      {.min = 0,
       .max = 1e6,
       .doc = "weight of being closer than inflation_dist to a static obstacle; raise it to keep to the "
              "middle"});
    v("dynamic_obstacle", dynamic_obstacle,
      {.min = 0, .max = 1e6, .doc = "the weight `obstacle`, for movers"});
    v("dynamic_inflation", dynamic_inflation,
      {.min = 0,
       .max = 1e6,
       .doc = "the weight `inflation`, for movers; raise it to pass people with a wider berth, which "
              "takes longer"});
    v("possible_inflation", possible_inflation,
      {.min = 0,
       .max = 1e6,
       .doc =
           "dynamic_inflation, for movers that may be furniture, just before they are confirmed; less with less "
           "confidence. Raise it where most of them are people; lower it when gaps beside furniture are avoided"});
  }
};

/// What solves the least-squares problem of a band: the same costs, the same minimum.
enum class Solver {
  ceres,   ///< the Ceres library
  banded,  ///< Levenberg's method on the block-banded normal equations: less time
};
constexpr auto choice_table(Solver) {
  return choices<Solver>({{Solver::ceres, "ceres"}, {Solver::banded, "banded"}});
}

/// Fewer poses have none that could move: start and goal stay.
inline constexpr int kFewestPoses = 3;

/// Iterations that the last solve of a first plan may take beyond its own, as long as four of them still gain 15 %.
inline constexpr int kFirstPlanOvertime = 16;

struct BandOptions {
  double dt_ref = 0.3;
  double dt_hysteresis = 0.1;
  int max_samples = 150;

  double min_obstacle_dist = 0.2;
  double inflation_dist = 0.3;
  double dynamic_obstacle_inflation_dist = 0.6;
  double narrow_passage_dist = 0.03;
  double clearance_step = 0.25;
  int max_obstacles_per_pose = 8;

  double penalty_epsilon = 0.02;
  bool consistent_motion = true;

  int no_outer_iterations = 2;
  int no_inner_iterations = 8;
  int warm_outer_iterations = 1;
  int warm_inner_iterations = 10;
  double function_tolerance = 1e-4;
  double weight_adapt_factor = 3.0;
  BandWeights weights;
  Solver solver = Solver::ceres;  ///< the parameter teb.solver, beside teb.band

  template <class Visitor>
  void fields(Visitor& v) {
    v("dt_ref", dt_ref,
      {.unit = "s", .min = 0.02, .max = 2, .doc = "wanted time between poses; lower is finer and slower"});
    v("dt_hysteresis", dt_hysteresis,
      {.unit = "s",
       .min = 0,
       .max = 2,
       .doc = "the band is resampled when an interval is further than this from dt_ref"});
    v("max_samples", max_samples,
      {.min = kFewestPoses, .max = 500, .doc = "most poses of a band; bounds the time of a cycle"});
    v("min_obstacle_dist", min_obstacle_dist,
      {.unit = "m",
       .min = 0,
       .max = 10,
       .doc = "wanted gap between footprint and obstacle; lower it for narrow doors"});
    v("inflation_dist", inflation_dist,
      {.unit = "m", .min = 0, .max = 10, .doc = "gap below which a static obstacle begins to cost a little"});
    v("dynamic_obstacle_inflation_dist", dynamic_obstacle_inflation_dist,
      {.unit = "m", .min = 0, .max = 10, .doc = "gap below which a mover begins to cost a little"});
    v("narrow_passage_dist", narrow_passage_dist,
      {.unit = "m",
       .min = 0,
       .max = 10,
       .doc =
           "between two obstacles that leave less than min_obstacle_dist at either side of the robot, but not less "
           "than this, half of what they leave is wanted; min_obstacle_dist: as teb_local_planner, which "
           "often waits in front of them"});
    v("clearance_step", clearance_step,
      {.unit = "m",
       .min = 0.02,
       .max = 10,
       .doc = "motion relative to an obstacle between two clearance tests"});
    v("max_obstacles_per_pose", max_obstacles_per_pose,
      {.min = 1,
       .max = 100,
       .doc =
           "how many obstacles of each kind (static, movers), the nearest ones, count in the cost of one pose; "
           "what is left out is told"});
    v("penalty_epsilon", penalty_epsilon,
      {.min = 0,
       .max = 1,
       .doc = "margin inside of every limit and distance at which its cost begins; raise it when plans "
              "touch their limits"});
    v("consistent_motion", consistent_motion,
      {.doc = "speed is taken along the mean heading and linear between the middles of segments; false: "
              "the formulas of teb_local_planner"});
    v("no_outer_iterations", no_outer_iterations,
      {.min = 1, .max = 20, .doc = "how many times a first plan is solved, resampled in between"});
    v("no_inner_iterations", no_inner_iterations,
      {.min = 1,
       .max = 100,
       .doc =
           "solver iterations in each solve of a first plan; the last one goes on, by 16 at most, while its "
           "cost falls fast"});
    v("warm_outer_iterations", warm_outer_iterations,
      {.min = 1, .max = 20, .doc = "how many times a band kept from the last cycle is solved"});
    v("warm_inner_iterations", warm_inner_iterations,
      {.min = 1,
       .max = 100,
       .doc = "solver iterations in each solve of a kept band; raise it when bands lag behind movers"});
    v("function_tolerance", function_tolerance,
      {.min = 0, .max = 0.1, .doc = "relative gain of an iteration below which a solve ends"});
    v("weight_adapt_factor", weight_adapt_factor,
      {.min = 1,
       .max = 10,
       .doc = "factor by which obstacle weights grow from one solve of a first plan to the next"});
    v("weights", weights, {.doc = "weights of the cost"});
  }

  std::optional<std::string> violated_rule() const {
    if (dt_hysteresis >= dt_ref) return "dt_hysteresis must be below dt_ref";
    return std::nullopt;
  }
};

}  // namespace bw::teb
