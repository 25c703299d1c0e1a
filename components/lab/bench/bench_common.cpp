#include "components/lab/bench/bench_common.hpp"

#include <algorithm>
#include <ctime>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <utility>

#include <nlohmann/json.hpp>

#include "components/lab/bench/bench.hpp"
#include "components/local_planner/teb/teb_options.hpp"
#include "runtime/atomic_file.hpp"

namespace bw {

namespace {

double cpu_ms(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double process_cpu_ms() { return cpu_ms(CLOCK_PROCESS_CPUTIME_ID); }
double thread_cpu_ms() { return cpu_ms(CLOCK_THREAD_CPUTIME_ID); }

double mean(const std::vector<double>& samples) {
  if (samples.empty()) return 0.0;
  return std::accumulate(samples.begin(), samples.end(), 0.0) / static_cast<double>(samples.size());
}

namespace {

std::function<nlohmann::ordered_json()>& provenance() {
  static std::function<nlohmann::ordered_json()> made;
  return made;
}

}  // namespace

void tell_provenance(std::function<nlohmann::ordered_json()> made) { provenance() = std::move(made); }

void write_json(const std::string& path, const nlohmann::ordered_json& value) {
  if (path.empty()) return;
  if (!value.is_object() || !provenance()) {
    write_file_atomically(path, value.dump(1) + "\n");
    return;
  }
  nlohmann::ordered_json told = value;
  told["made"] = provenance()();
  write_file_atomically(path, told.dump(1) + "\n");
}

PlannerOptions options_for(const SceneFile& file, BenchWeights weights, PlannerOptions options,
                           double robot_radius) {
  // Open-loop scenes are about bands: what gets out of somebody's way is left to the closed loop.
  if (!file.closed_loop) options.driving.evasion_horizon = options.driving.mover_margin = 0.0;
  teb::BandOptions& band = band_of(options);
  band.dt_ref = file.dt_ref;
  band.dt_hysteresis = file.dt_hysteresis;
  band.min_obstacle_dist = std::max(0.0, file.min_dist - robot_radius);
  band.inflation_dist = std::max(0.0, file.inflation_dist - robot_radius);
  band.dynamic_obstacle_inflation_dist = std::max(0.0, file.dynamic_inflation_dist - robot_radius);
  if (weights == BenchWeights::defaults) return options;
  band.narrow_passage_dist = band.min_obstacle_dist;  // the rules ask for it everywhere
  const SceneWeights& w = file.weights;
  band.penalty_epsilon = w.penalty_epsilon;
  band.consistent_motion = false;
  band.weights = {w.time,          w.kinematics_nh,    w.forward_drive,    w.max_vel_x,
                  w.max_vel_theta, w.acc_lim_x,        w.acc_lim_theta,    w.obstacle,
                  w.inflation,     w.dynamic_obstacle, w.dynamic_inflation};
  return options;
}

teb::BandOptions& band_of(PlannerOptions& options) { return options.of<teb::TebOptions>("teb").band; }
const teb::BandOptions& band_of(const PlannerOptions& options) {
  return options.of<teb::TebOptions>("teb").band;
}

std::vector<Scene> select_scenes(const SceneFile& file, const std::string& prefix) {
  std::vector<Scene> selected;
  for (const Scene& scene : file.scenes) {
    if (scene.name.starts_with(prefix)) selected.push_back(scene);
  }
  if (!selected.empty()) return selected;
  std::string known;
  for (const Scene& scene : file.scenes) known += (known.empty() ? "" : ", ") + scene.name;
  throw std::runtime_error("no scene begins with '" + prefix + "'; known: " + known);
}

}  // namespace bw
