// What a timed elastic band is asked to be: resolution, clearances and the weights of its cost. Names and
// meanings follow the public teb_local_planner package; defaults differ where noted. One set serves every
// candidate band.
#pragma once

#include <optional>
#include <string>

#include "runtime/base/choice.hpp"
#include "runtime/base/field.hpp"

namespace bw::teb {

/// Weights of the squared residuals (theory.md 6.1). Limits are stiffer than the package's 2/1/1/1, so that
/// plans keep them.
struct BandWeights {
  double time = 1.0;
  double kinematics_nh =
      1000.0;  ///< of what keeps both poses of a segment on one arc; by code, as the next four of the limits
  double forward_drive = 1.0;
  double max_vel_x = 40.0;      ///< below it plans are faster than the robot
  double max_vel_theta = 20.0;  ///< of the turn rate
  double acc_lim_x = 10.0;      ///< below it the robot cannot follow its plan
  double acc_lim_theta = 10.0;  ///< of the angular acceleration
  double obstacle = 50.0;
  double inflation = 0.1;
  double dynamic_obstacle = 50.0;
  double dynamic_inflation = 2.0;
  /// dynamic_inflation, for movers that may be furniture, just before they are confirmed; less with less
  /// confidence
  static constexpr double kPossibleInflation = 0.02;

  template <class Visitor>
  void fields(Visitor& v) {
    v("time", time,
      {.min = 1e-6,
       .max = 1e4,
       .doc = "weight of the squared time intervals; raise it to drive faster and bolder"});
    v("forward_drive", forward_drive,
      {.min = 0, .max = 1e6, .doc = "weight of driving backward; raise it to forbid reversing"});
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
    v.retired({"possible_inflation"}, "a constant of band_options.hpp");
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

/// Iterations that the last solve of a first plan may take beyond its own, as long as four of them still gain
/// 15 %.
inline constexpr int kFirstPlanOvertime = 16;

struct BandOptions {
  double dt_ref = 0.3;
  double min_obstacle_dist = 0.2;
  double inflation_dist = 0.3;
  double dynamic_obstacle_inflation_dist = 0.6;

  // Set by code: scenes of a bench that bring rules of their own, and tests.
  double dt_hysteresis =
      0.1;                ///< the band is resampled when an interval is further than this from dt_ref [s]
  int max_samples = 150;  ///< most poses; bounds the time of a cycle
  /// Between two obstacles that leave less than min_obstacle_dist at either side of the robot, but not less
  /// than this, half of what they leave is wanted; min_obstacle_dist: as teb_local_planner, which often waits
  /// in front of them [m].
  double narrow_passage_dist = 0.03;
  double clearance_step = 0.25;    ///< motion relative to an obstacle between two clearance tests [m]
  double penalty_epsilon = 0.02;   ///< inside of every limit and distance at which its cost begins
  bool consistent_motion = true;   ///< theory.md 6.1; else the formulas of teb_local_planner
  int no_outer_iterations = 2;     ///< solves of a first plan, resampled in between
  int no_inner_iterations = 8;     ///< of the solver in each; the last goes on, by kFirstPlanOvertime at most
  int warm_outer_iterations = 1;   ///< solves of a band kept from the last cycle
  int warm_inner_iterations = 10;  ///< iterations of the solver in each of these
  /// The nearest of each kind (static, movers) that count in the cost of one pose; what is left out is told.
  int max_obstacles_per_pose = 8;
  double function_tolerance = 1e-4;  ///< relative gain of an iteration below which a solve ends
  double weight_adapt_factor =
      3.0;  ///< by which obstacle weights grow from one solve of a first plan to the next
  BandWeights weights;
  Solver solver = Solver::ceres;  ///< the parameter teb.solver, beside teb.band

  template <class Visitor>
  void fields(Visitor& v) {
    v("dt_ref", dt_ref,
      {.unit = "s", .min = 0.02, .max = 2, .doc = "wanted time between poses; lower is finer and slower"});
    v("min_obstacle_dist", min_obstacle_dist,
      {.unit = "m",
       .min = 0,
       .max = 10,
       .doc = "wanted gap between footprint and obstacle; lower it for narrow doors"});
    v("inflation_dist", inflation_dist,
      {.unit = "m",
       .min = 0,
       .max = 10,
       .doc = "gap below which a static obstacle begins to cost a little; raise it to keep to the middle"});
    v("dynamic_obstacle_inflation_dist", dynamic_obstacle_inflation_dist,
      {.unit = "m",
       .min = 0,
       .max = 10,
       .doc = "gap below which a mover begins to cost a little; raise it for a wider berth"});
    v("weights", weights, {.doc = "weights of the cost"});
    v.retired({"max_obstacles_per_pose", "warm_inner_iterations"}, "set by code alone, in band_options.hpp");
  }

  std::optional<std::string> violated_rule() const {
    if (dt_hysteresis >= dt_ref)
      return "dt_ref must be longer than 0.1 s, by which intervals may differ from it";
    return std::nullopt;
  }
};

}  // namespace bw::teb
