#include "components/lab/experiments/edwa_experiment.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "components/lab/experiments/edwa_criteria.hpp"
#include "components/local_planner/dwa/dwa_options.hpp"

namespace bw {
namespace {

// Table 3.2 [m/s]: scenes x pairings.
constexpr double kPublished[kEdwaScenes][kEdwaPairings.size()] = {
    {0.8895, 0.9531, 0.9711}, {0.8693, 0.9441, 0.9630}, {0.8910, 0.9439, 0.9527}, {0.7937, 0.9361, 0.9461}};

EdwaRun judged(const FloorRun& run, std::uint64_t seed, const FloorRules& rules) {
  EdwaRun result{seed, run.outcome, run.time, run.mean_speed, run.smallest_gap};
  const double speeding_up = rules.limits.v_max / rules.limits.acc_max;
  result.lowest_v = rules.limits.v_max;
  for (const FloorSample& sample : run.samples) {
    result.max_delta = std::max(result.max_delta, delta_min(sample.gap));
    if (sample.time >= speeding_up) result.lowest_v = std::min(result.lowest_v, sample.v);
  }
  result.max_delta = std::max(result.max_delta, delta_min(run.smallest_gap));
  result.others_touched = run.smallest_other_gap < 0.0;
  result.not_ok = run.not_ok;
  return result;
}

void sum_up(EdwaRow& row) {
  double sum = 0.0;
  double squares = 0.0;
  double deltas = 0.0;
  row.lowest_v = std::numeric_limits<double>::infinity();
  for (const EdwaRun& run : row.runs) {
    deltas += run.max_delta;
    row.lowest_v = std::min(row.lowest_v, run.lowest_v);
    if (run.outcome == FloorOutcome::contact) ++row.contacts;
    if (run.outcome == FloorOutcome::timeout) ++row.timeouts;
    if (run.outcome != FloorOutcome::reached) continue;
    ++row.success;
    sum += run.mean_speed;
  }
  row.mean_max_delta = deltas / static_cast<double>(row.runs.size());
  row.mean = sum / row.success;
  for (const EdwaRun& run : row.runs) {
    if (run.outcome == FloorOutcome::reached)
      squares += (run.mean_speed - row.mean) * (run.mean_speed - row.mean);
  }
  row.sd = row.success > 1 ? std::sqrt(squares / (row.success - 1)) : 0.0;
}

double gain(const EdwaRow& row, const EdwaRow& dwa) {
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < row.runs.size(); ++i) {
    if (row.runs[i].outcome != FloorOutcome::reached || dwa.runs[i].outcome != FloorOutcome::reached)
      continue;
    sum += row.runs[i].mean_speed - dwa.runs[i].mean_speed;
    ++count;
  }
  return sum / count;
}

}  // namespace

std::string to_string(const EdwaPairing& pairing) {
  std::string text = std::string(pairing.robot) + "-" + std::string(pairing.others);
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

PlannerOptions published_edwa_options() {
  PlannerOptions options;
  auto& published = options.of<dwa::DwaOptions>("dwa");
  published.profile = dwa::Profile::scales;
  published.carrot_distance = 0.0;
  published.arc_to_goal = false;
  published.check_movers = false;
  published.hold_before_braking = false;
  published.leave_margin = false;
  options.driving.evasion_horizon = 0.0;
  options.driving.xy_goal_tolerance = 0.3;
  return options;
}

FloorRules published_edwa_rules() {
  FloorRules rules;
  rules.limits = {.v_max = 1.0,
                  .v_back_max = 0.0,
                  .omega_max = 0.35,
                  .acc_max = 1.0,
                  .alpha_max = 1.0,
                  .stop_deceleration = 1.0};
  return rules;
}

double delta_min(double gap) {
  const double d = std::max(gap, 0.0) / 3.0;
  return std::exp(-d * d);
}

FloorRun run_edwa_scene(int scene, const EdwaPairing& pairing, std::uint64_t seed,
                        const EdwaExperimentOptions& options) {
  std::vector<FloorRobot> robots;
  for (const StartAndGoal& errand : edwa_scene(scene, seed).errands) {
    const std::string_view name = robots.empty() ? pairing.robot : pairing.others;
    FloorRobot robot;
    robot.planner = make_planner(name, options.planners);
    robot.runs_hrvo = name == "edwa";
    robot.pose = errand.start;
    robot.goal = errand.goal;
    robots.push_back(std::move(robot));
  }
  return run_on_floor(std::move(robots), options.rules);
}

EdwaTable run_edwa_experiment(const EdwaExperimentOptions& options, const EdwaProgress& progress) {
  EdwaTable table;
  for (int scene = 0; scene < kEdwaScenes; ++scene) {
    for (std::size_t pairing = 0; pairing < kEdwaPairings.size(); ++pairing) {
      EdwaRow row{.scene = scene, .pairing = kEdwaPairings[pairing], .published = kPublished[scene][pairing]};
      for (std::uint64_t seed = options.first_seed; seed <= options.last_seed; ++seed) {
        FloorRun run = run_edwa_scene(scene, row.pairing, seed, options);
        row.runs.push_back(judged(run, seed, options.rules));
        if (seed == options.first_seed) row.example = std::move(run.samples);
      }
      sum_up(row);
      table.rows.push_back(std::move(row));
      table.rows.back().gain_on_same_seeds =
          gain(table.rows.back(), table.rows[table.rows.size() - 1 - pairing]);
      if (progress) {
        progress(table.rows.back(), static_cast<int>(table.rows.size()),
                 kEdwaScenes * static_cast<int>(kEdwaPairings.size()));
      }
    }
  }
  table.criteria = edwa_criteria(table.rows);
  return table;
}

}  // namespace bw
