#include "components/lab/experiments/edwa_report.hpp"

#include <cmath>

#include "components/local_planner/dwa/dwa_options.hpp"
#include "components/local_planner/hrvo/hrvo_options.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string_view name_of(FloorOutcome outcome) {
  if (outcome == FloorOutcome::reached) return "reached";
  return outcome == FloorOutcome::contact ? "contact" : "timeout";
}

Json runs_json(const std::vector<EdwaRun>& runs) {
  Json list = Json::array();
  for (const EdwaRun& run : runs) {
    list.push_back({{"seed", run.seed},
                    {"outcome", name_of(run.outcome)},
                    {"time_s", run.time},
                    {"mean_speed", run.mean_speed},
                    {"smallest_gap_m", number(run.smallest_gap)},
                    {"max_delta_min", run.max_delta},
                    {"lowest_v", run.lowest_v},
                    {"others_touched", run.others_touched},
                    {"cycles_without_admissible_velocity", run.not_ok}});
  }
  return list;
}

Json rows_json(const EdwaTable& table) {
  Json list = Json::array();
  for (const EdwaRow& row : table.rows) {
    list.push_back({{"scene", edwa_scene_name(row.scene)},
                    {"pairing", to_string(row.pairing)},
                    {"published", row.published},
                    {"mean", number(row.mean)},
                    {"sd", row.sd},
                    {"runs", row.runs.size()},
                    {"success", row.success},
                    {"contacts", row.contacts},
                    {"timeouts", row.timeouts},
                    {"gain_on_same_seeds", number(row.gain_on_same_seeds)},
                    {"mean_max_delta_min", row.mean_max_delta},
                    {"lowest_v", row.lowest_v},
                    {"per_seed", runs_json(row.runs)}});
  }
  return list;
}

dwa::DwaOptions& dwa_of(EdwaVariant& variant) { return variant.options.planners.of<dwa::DwaOptions>("dwa"); }
dwa::EdwaOptions& edwa_of(EdwaVariant& variant) {
  return variant.options.planners.of<dwa::EdwaOptions>("edwa");
}

}  // namespace

std::vector<EdwaVariant> edwa_variants(std::uint64_t first_seed, std::uint64_t last_seed) {
  const EdwaExperimentOptions base{.first_seed = first_seed, .last_seed = last_seed};
  std::vector<EdwaVariant> variants(
      8, EdwaVariant{"default", "The reading of every decision that is the default here, Table 3.1.", base});
  variants[1].name = "held braking";
  variants[1].meaning =
      "Braking is judged with the command held for one more period; arcs that lead out of the contact margin "
      "are admissible.";
  dwa_of(variants[1]).hold_before_braking = true;
  dwa_of(variants[1]).leave_margin = true;
  variants[2].name = "guarded";
  variants[2].meaning =
      "Besides held braking, a velocity must leave room to brake clear of where the others will be, the goal is "
      "reached on one arc, and evasive moves.";
  dwa_of(variants[2]) = {};
  dwa_of(variants[2]).profile = dwa::Profile::scales;
  dwa_of(variants[2]).carrot_distance = 0.0;
  variants[2].options.planners.driving.evasion_horizon = DrivingOptions{}.evasion_horizon;
  variants[3].name = "sum";
  variants[3].meaning = "Each column of scores divided by its sum.";
  dwa_of(variants[3]).normalisation = dwa::Normalisation::sum;
  variants[4].name = "sample";
  variants[4].meaning =
      "As the MATLAB teaching sample: distance from the end pose only, capped at 2 m, column sums.";
  dwa_of(variants[4]).normalisation = dwa::Normalisation::sum;
  dwa_of(variants[4]).teaching_sample = true;
  variants[5].name = "direction only";
  variants[5].meaning = "EDWA without HRVO's speed, and everybody is taken to share the avoiding.";
  edwa_of(variants[5]).hrvo_speed = false;
  variants[5].options.planners.of<hrvo::HrvoOptions>("hrvo").reciprocity = hrvo::Reciprocity::all;
  variants[6].name = "as printed";
  variants[6].meaning = "The heading term (3.4) as printed.";
  edwa_of(variants[6]).heading = dwa::EdwaHeading::hrvo_printed;
  variants[7].name = "as driven here";
  variants[7].meaning =
      "Bandwagon's defaults: the plan leads, HRVO's direction and speed while somebody could be met.";
  dwa_of(variants[7]) = {};
  variants[7].options.planners.driving.evasion_horizon = DrivingOptions{}.evasion_horizon;
  return variants;
}

nlohmann::ordered_json edwa_json(const std::vector<EdwaResult>& results) {
  const EdwaResult& first = results.at(0);
  Json json = {{"experiment", "edwa"},
               {"seeds", {first.variant.options.first_seed, first.variant.options.last_seed}},
               {"rows", rows_json(first.table)},
               {"criteria", criteria_json(first.table.criteria)},
               {"variants", Json::array()}};
  for (std::size_t i = 1; i < results.size(); ++i) {
    json["variants"].push_back({{"name", results[i].variant.name},
                                {"meaning", results[i].variant.meaning},
                                {"rows", rows_json(results[i].table)},
                                {"criteria", criteria_json(results[i].table.criteria)}});
  }
  return json;
}

}  // namespace bw
