#include "components/lab/bench/bench_conditions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "components/local_planner/homotopy/homotopy_options.hpp"
#include "components/local_planner/teb/teb_options.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const teb::BandWeights& w) {
  return {{"time", w.time},
          {"kinematics_nh", w.kinematics_nh},
          {"forward_drive", w.forward_drive},
          {"max_vel_x", w.max_vel_x},
          {"max_vel_theta", w.max_vel_theta},
          {"acc_lim_x", w.acc_lim_x},
          {"acc_lim_theta", w.acc_lim_theta},
          {"obstacle", w.obstacle},
          {"inflation", w.inflation},
          {"dynamic_obstacle", w.dynamic_obstacle},
          {"dynamic_inflation", w.dynamic_inflation},
          {"possible_inflation", w.kPossibleInflation}};
}

}  // namespace

const char* name_of(BenchWeights weights) { return weights == BenchWeights::file ? "file" : "default"; }

Json to_json(const BenchConditions& c) {
  const teb::BandOptions& band = band_of(c.options);
  const DrivingOptions& driving = c.options.driving;
  return {{"weights_set", name_of(c.weights)},
          {"weights", to_json(band.weights)},
          {"budget",
           {{"cold",
             {{"outer", band.no_outer_iterations},
              {"inner", band.no_inner_iterations},
              {"overtime", teb::kFirstPlanOvertime}}},
            {"warm", {{"outer", band.warm_outer_iterations}, {"inner", band.warm_inner_iterations}}},
            {"function_tolerance", band.function_tolerance},
            {"max_iterations", c.max_iterations},
            {"max_number_classes", c.options.of<homotopy::HomotopyOptions>("homotopy").max_number_classes}}},
          {"limits",
           {{"v_max", c.limits.v_max},
            {"v_back_max", c.limits.v_back_max},
            {"omega_max", c.limits.omega_max},
            {"acc_max", c.limits.acc_max},
            {"alpha_max", c.limits.alpha_max},
            {"penalty_epsilon", band.penalty_epsilon}}},
          {"layers",
           {{"evasion_horizon_s", driving.evasion_horizon},
            {"mover_margin_m", driving.mover_margin},
            {"mover_margin_cost", teb::kMoverMarginCost},
            {"feasibility_check_s", driving.feasibility_check_time},
            {"feasibility_margin_m", driving.feasibility_margin},
            {"consistent_motion", band.consistent_motion},
            {"dt_ref_s", band.dt_ref},
            {"min_obstacle_dist_m", band.min_obstacle_dist},
            {"inflation_dist_m", band.inflation_dist},
            {"dynamic_obstacle_inflation_dist_m", band.dynamic_obstacle_inflation_dist}}}};
}

std::string in_a_line(const BenchConditions& c) {
  const teb::BandOptions& band = band_of(c.options);
  const DrivingOptions& driving = c.options.driving;
  const std::string evasion =
      driving.evasion_horizon > 0.0 ? fmt::format("{:g} s", driving.evasion_horizon) : "off";
  return fmt::format(
      "{} weights; outer x inner cold {} x {} and {} while falling fast, warm {} x {}, at most {} a cycle; limits v {:g} back {:g} w {:g} a {:g} "
      "alpha {:g}, epsilon {:g}; evasion {}, mover margin {:g} m, check {:g} s, dt_ref {:g} s",
      name_of(c.weights), band.no_outer_iterations, band.no_inner_iterations, teb::kFirstPlanOvertime,
      band.warm_outer_iterations, band.warm_inner_iterations, c.max_iterations, c.limits.v_max,
      c.limits.v_back_max, c.limits.omega_max, c.limits.acc_max, c.limits.alpha_max, band.penalty_epsilon,
      evasion, driving.mover_margin, driving.feasibility_check_time, band.dt_ref);
}

}  // namespace bw
