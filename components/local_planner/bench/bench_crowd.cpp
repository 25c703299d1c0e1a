#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "components/local_planner/bench/bench.hpp"
#include "components/local_planner/bench/bench_common.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kStepsPerPeriod = 5;
constexpr double kCollisionIndexSigma = 0.6;  // [m] spec 7.7

// Position on a line that is mirrored at low and high.
double fold(double x, double low, double high) {
  const double span = high - low;
  double r = std::fmod(x - low, 2.0 * span);
  if (r < 0.0) r += 2.0 * span;
  return low + (r <= span ? r : 2.0 * span - r);
}

double fold_sign(double x, double low, double high) {
  const double span = high - low;
  double r = std::fmod(x - low, 2.0 * span);
  if (r < 0.0) r += 2.0 * span;
  return r <= span ? 1.0 : -1.0;
}

Vector2 position_at(const SceneObstacle& o, const SceneBox& box, double time) {
  if (!o.moves()) return o.position;
  const Vector2 p = o.position + time * o.velocity;
  return {fold(p.x(), box.x_min, box.x_max), fold(p.y(), box.y_min, box.y_max)};
}

Vector2 velocity_at(const SceneObstacle& o, const SceneBox& box, double time) {
  const Vector2 p = o.position + time * o.velocity;
  return {o.velocity.x() * fold_sign(p.x(), box.x_min, box.x_max),
          o.velocity.y() * fold_sign(p.y(), box.y_min, box.y_max)};
}

struct Episode {
  std::string name;
  bool success = false;
  bool collision = false;
  double time = 0.0;
  double min_clearance = std::numeric_limits<double>::infinity();
  double max_collision_index = 0.0;
  double rms_jerk = 0.0;
  int not_ok = 0;
  std::vector<double> ms;
};

PlanningProblem problem_at(const Scene& scene, const SceneFile& file, double time, const Pose2& pose,
                           const Twist2& twist) {
  PlanningProblem problem;
  problem.now = Time::seconds(1.0 + time);
  problem.pose = pose;
  problem.twist = twist;
  problem.plan = {scene.start, scene.goal};
  problem.footprint.radius = file.closed_loop->robot_radius;
  problem.limits = file.limits;
  std::uint32_t id = 0;
  for (const SceneObstacle& o : scene.obstacles) {
    ++id;
    if (!o.moves()) {
      problem.obstacles.discs.push_back({o.position, o.radius});
      continue;
    }
    Mover mover;
    mover.id = id;
    mover.position = position_at(o, file.closed_loop->box, time);
    mover.velocity = velocity_at(o, file.closed_loop->box, time);
    mover.radius = o.radius;
    problem.movers.push_back(mover);
  }
  return problem;
}

void observe(const Scene& scene, const SceneFile& file, double time, const Pose2& pose, Episode& episode) {
  for (const SceneObstacle& o : scene.obstacles) {
    const double centre = (position_at(o, file.closed_loop->box, time) - pose.position()).norm();
    episode.min_clearance = std::min(episode.min_clearance, centre - o.radius);
    if (!o.moves()) continue;
    const double index = std::exp(-centre * centre / (2.0 * kCollisionIndexSigma * kCollisionIndexSigma));
    episode.max_collision_index = std::max(episode.max_collision_index, index);
  }
  episode.collision = episode.collision || episode.min_clearance < file.closed_loop->robot_radius;
}

Episode run(const Scene& scene, const SceneFile& file, LocalPlanner& planner) {
  const ClosedLoop& rule = *file.closed_loop;
  const Limits& limits = file.limits;
  const double period = rule.control_period;
  Episode episode;
  episode.name = scene.name;
  Pose2 pose = scene.start;
  Twist2 twist;
  std::vector<double> accelerations;
  const int cycles = static_cast<int>(std::lround(rule.timeout / period));
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const double begin = cycle * period;
    const PlanningProblem problem = problem_at(scene, file, begin, pose, twist);
    const double before = process_cpu_ms();
    const PlanningResult result = planner.plan(problem);
    episode.ms.push_back(process_cpu_ms() - before);
    if (result.status != PlanningStatus::ok) ++episode.not_ok;

    const double dv = 2.0 * limits.acc_max * period;
    const double domega = 2.0 * limits.alpha_max * period;
    const Twist2 last = twist;
    twist.v =
        std::clamp(std::clamp(result.command.v, -limits.v_back_max, limits.v_max), last.v - dv, last.v + dv);
    twist.omega = std::clamp(std::clamp(result.command.omega, -limits.omega_max, limits.omega_max),
                             last.omega - domega, last.omega + domega);
    accelerations.push_back((twist.v - last.v) / period);
    const double h = period / kStepsPerPeriod;
    for (int step = 1; step <= kStepsPerPeriod; ++step) {
      const double heading = pose.theta + twist.omega * h / 2.0;
      pose = {pose.x + twist.v * h * std::cos(heading), pose.y + twist.v * h * std::sin(heading),
              wrap_angle(pose.theta + twist.omega * h)};
      observe(scene, file, begin + step * h, pose, episode);
    }
    episode.time = begin + period;
    if ((pose.position() - scene.goal.position()).norm() <= rule.goal_tolerance) {
      episode.success = !episode.collision;
      break;
    }
  }
  double squares = 0.0;
  for (std::size_t i = 1; i < accelerations.size(); ++i) {
    const double jerk = (accelerations[i] - accelerations[i - 1]) / period;
    squares += jerk * jerk;
  }
  if (accelerations.size() > 1)
    episode.rms_jerk = std::sqrt(squares / static_cast<double>(accelerations.size() - 1));
  return episode;
}

double mean(const std::vector<double>& samples) {
  double sum = 0.0;
  for (const double s : samples) sum += s;
  return samples.empty() ? 0.0 : sum / static_cast<double>(samples.size());
}

}  // namespace

int bench_crowd(const BenchCrowdArguments& arguments) {
  const SceneFile file = read_scene_file(arguments.scenes);
  if (!file.closed_loop)
    throw std::runtime_error(arguments.scenes + ": control_period is missing: not a closed-loop file");
  const LocalPlannerOptions options =
      arguments.weights == BenchWeights::defaults
          ? arguments.options
          : options_for(file, arguments.weights, arguments.options, file.closed_loop->robot_radius);
  Json rows = Json::array();
  std::vector<double> all_ms, times, clearances, indices, jerks;
  int successes = 0;
  int episodes = 0;
  for (const Scene& scene : select_scenes(file, arguments.scene)) {
    const std::unique_ptr<LocalPlanner> planner = make_planner(arguments.planner, options);
    const Episode e = run(scene, file, *planner);
    const double worst = *std::max_element(e.ms.begin(), e.ms.end());
    std::printf(
        "%-14s %-9s %5.1f s  clearance %.3f  CI %.3f  jerk %.2f  %5.2f ms mean %5.2f p95 %5.2f max  stops "
        "%d\n",
        e.name.c_str(),
        e.success     ? "ok"
        : e.collision ? "COLLISION"
                      : "TIMEOUT",
        e.time, e.min_clearance, e.max_collision_index, e.rms_jerk, mean(e.ms), quantile(e.ms, 0.95), worst,
        e.not_ok);
    std::fflush(stdout);
    rows.push_back({{"name", e.name},
                    {"success", e.success},
                    {"collision", e.collision},
                    {"time_s", e.time},
                    {"min_clearance_m", e.min_clearance},
                    {"max_collision_index", e.max_collision_index},
                    {"rms_jerk_mps3", e.rms_jerk},
                    {"not_ok_cycles", e.not_ok},
                    {"mean_ms", mean(e.ms)},
                    {"p95_ms", quantile(e.ms, 0.95)},
                    {"max_ms", worst}});
    ++episodes;
    successes += e.success ? 1 : 0;
    all_ms.insert(all_ms.end(), e.ms.begin(), e.ms.end());
    times.push_back(e.time);
    clearances.push_back(e.min_clearance);
    indices.push_back(e.max_collision_index);
    jerks.push_back(e.rms_jerk);
  }
  const Interval wilson = wilson95(successes, episodes);
  std::printf(
      "%s: %d of %d (Wilson 95 %%: %.3f to %.3f), %.2f s, clearance %.3f, CI %.3f, jerk %.2f, %.2f ms mean, "
      "%.2f ms p95\n",
      arguments.planner.c_str(), successes, episodes, wilson.low, wilson.high, mean(times), mean(clearances),
      mean(indices), mean(jerks), mean(all_ms), quantile(all_ms, 0.95));
  write_json(arguments.json, {{"planner", arguments.planner},
                              {"episodes", std::move(rows)},
                              {"summary",
                               {{"episodes", episodes},
                                {"successes", successes},
                                {"wilson95", {wilson.low, wilson.high}},
                                {"mean_time_s", mean(times)},
                                {"mean_min_clearance_m", mean(clearances)},
                                {"mean_max_collision_index", mean(indices)},
                                {"mean_rms_jerk_mps3", mean(jerks)},
                                {"mean_ms", mean(all_ms)},
                                {"p95_ms", quantile(all_ms, 0.95)},
                                {"max_ms", quantile(all_ms, 1.0)}}}});
  return 0;
}

}  // namespace bw
