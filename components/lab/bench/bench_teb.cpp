#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "components/lab/bench/band_evaluator.hpp"
#include "components/lab/bench/bench.hpp"
#include "components/lab/bench/bench_common.hpp"
#include "components/lab/bench/bench_conditions.hpp"
#include "components/local_planner/homotopy/homotopy_options.hpp"
#include "components/local_planner/teb/band_optimizer.hpp"
#include "components/local_planner/teb/band_trajectory.hpp"
#include "runtime/base/quantile.hpp"

namespace bw {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kMaxIterations = 1000;
constexpr double kComparableInterval = 0.05;  // of dt_ref: the time term falls when a band is cut finer

PlanningProblem problem_for(const Scene& scene, const SceneFile& file) {
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.pose = scene.start;
  problem.plan = {scene.start, scene.goal};
  problem.footprint.radius = 0.0;  // the scenes treat the robot as a point that keeps min_dist
  problem.limits = file.limits;
  problem.budget.max_iterations = kMaxIterations;
  return problem;
}

void set_obstacles(PlanningProblem& problem, const std::vector<SceneObstacle>& obstacles) {
  problem.obstacles = {};
  problem.movers.clear();
  for (const SceneObstacle& o : obstacles) {
    if (o.moves()) {
      Mover mover;
      mover.id = static_cast<std::uint32_t>(problem.movers.size());
      mover.position = o.position;
      mover.velocity = o.velocity;
      mover.radius = o.radius;
      problem.movers.push_back(mover);
    } else if (o.radius > 0.0) {
      problem.obstacles.discs.push_back({o.position, o.radius});
    } else {
      problem.obstacles.points.push_back(o.position);
    }
  }
}

std::vector<SceneObstacle> later(std::vector<SceneObstacle> obstacles, double time) {
  for (SceneObstacle& o : obstacles) o.position += time * o.velocity;
  return obstacles;
}

// Moves the robot along its last plan: linear in the segment, with that segment's speeds.
void follow(const std::vector<EvaluatedPose>& band, double time, PlanningProblem& problem) {
  for (std::size_t i = 0; i + 1 < band.size(); ++i) {
    if (time <= band[i].dt || i + 2 == band.size()) {
      const double s = std::min(time / band[i].dt, 1.0);
      const Pose2& a = band[i].pose;
      const Pose2& b = band[i + 1].pose;
      problem.pose = {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y),
                      wrap_angle(a.theta + s * wrap_angle(b.theta - a.theta))};
      problem.twist = segment_twist(band[i], band[i + 1]);
      return;
    }
    time -= band[i].dt;
  }
}

constexpr int kCandidates = 4;
constexpr int kUnlimited = 1000;  // iterations

struct Plan {
  std::vector<EvaluatedPose> band;
  BandQuality quality;
  int iterations = 0;
  std::size_t candidates = 0;  ///< bands optimised

  double mean_dt() const {
    return band.size() > 1 ? quality.time / static_cast<double>(band.size() - 1) : 0.0;
  }
  bool is_comparable(const SceneFile& file) const {
    return std::abs(mean_dt() - file.dt_ref) <= kComparableInterval * file.dt_ref;
  }
  /// The total with the time term of intervals that are all dt_ref long: that of bands cut otherwise
  /// compares.
  double cost_at_dt_ref(const SceneFile& file) const {
    return quality.cost.total() - quality.cost.time + file.weights.time * file.dt_ref * quality.time;
  }
};

/// One call of the planner.
struct Sample {
  double time = 0.0;  ///< since the first one [s]; obstacles are where they are then
  Pose2 start;
  Twist2 start_twist;
  std::vector<TrajectoryPoint> plan;
};

struct SceneRun {
  Plan cold, warm;
  std::vector<double> cold_ms, warm_ms;
  std::vector<Sample> samples;  ///< of the first repetition
};

// One band as `teb` keeps it, solved by the banded solver and never checked: the time to compare with.
class LimitPlanner final : public LocalPlanner {
 public:
  explicit LimitPlanner(const teb::BandOptions& options) : options_(options) {
    options_.solver = teb::Solver::banded;
  }

  PlanningResult plan(const PlanningProblem& problem) override {
    if (band_.empty()) {
      band_ = teb::band_along(problem.plan, problem.pose, problem.limits, options_);
    } else {
      teb::advance(band_, problem.pose, 1.0, options_);
    }
    const teb::ObstacleField field =
        teb::field_of(problem.obstacles, problem.movers, problem.pose.position(), problem.footprint);
    PlanningResult result;
    result.iterations =
        teb::optimize(band_, {problem.limits, problem.twist, true, &field}, options_, kUnlimited).iterations;
    result.trajectory = teb::to_trajectory(band_, problem.twist, true);
    return result;
  }
  void reset() override { band_ = {}; }

 private:
  teb::BandOptions options_;
  teb::Band band_;
};

using PlannerMaker = std::function<std::unique_ptr<LocalPlanner>()>;

SceneRun run(const Scene& scene, const SceneFile& file, int repetitions, const PlannerMaker& make) {
  SceneRun run;
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    const std::unique_ptr<LocalPlanner> planner = make();
    PlanningProblem problem = problem_for(scene, file);
    for (int cycle = 0; cycle <= file.warm_cycles; ++cycle) {
      const std::vector<SceneObstacle> obstacles = later(scene.obstacles, cycle * file.replan_period);
      set_obstacles(problem, obstacles);
      const double before = process_cpu_ms();
      const PlanningResult result = planner->plan(problem);
      (cycle == 0 ? run.cold_ms : run.warm_ms).push_back(process_cpu_ms() - before);
      if (result.trajectory.size() < 2)
        throw std::runtime_error(scene.name + ": no trajectory: " + result.reason);
      const std::vector<EvaluatedPose> band = to_band(result.trajectory);
      if (cycle == 0 || cycle == file.warm_cycles) {
        (cycle == 0 ? run.cold : run.warm) =
            Plan{.band = band,
                 .quality = evaluate_band(band, problem.twist, file, obstacles),
                 .iterations = result.iterations,
                 .candidates = result.candidates.size()};
      }
      if (repetition == 0)
        run.samples.push_back({cycle * file.replan_period, problem.pose, problem.twist, result.trajectory});
      follow(band, file.replan_period, problem);
      problem.now = problem.now + Duration::seconds(file.replan_period);
    }
  }
  return run;
}

Json to_json(const std::vector<Sample>& samples) {
  Json list = Json::array();
  for (const Sample& s : samples) {
    Json plan = Json::array();
    for (const TrajectoryPoint& p : s.plan)
      plan.push_back({p.time, p.pose.x, p.pose.y, p.pose.theta, p.twist.v, p.twist.omega});
    list.push_back({{"t", s.time},
                    {"start", {s.start.x, s.start.y, s.start.theta}},
                    {"start_twist", {s.start_twist.v, s.start_twist.omega}},
                    {"plan", std::move(plan)}});
  }
  return list;
}

Json to_json(const Plan& plan, const SceneFile& file) {
  const BandQuality& q = plan.quality;
  Json poses = Json::array();
  for (const EvaluatedPose& p : plan.band) poses.push_back({p.pose.x, p.pose.y, p.pose.theta, p.dt});
  return {{"time_s", q.time},
          {"mean_dt_s", plan.mean_dt()},
          {"comparable", plan.is_comparable(file)},
          {"iterations", plan.iterations},
          {"max_nonholonomic", q.max_nonholonomic},
          {"max_excess",
           {{"v", q.excess_v}, {"omega", q.excess_omega}, {"a", q.excess_a}, {"alpha", q.excess_alpha}}},
          {"clearance_poses_m", q.clearance_poses},
          {"clearance_segments_m", q.clearance_segments},
          {"cost",
           {{"time", q.cost.time},
            {"nonholonomic", q.cost.nonholonomic},
            {"velocity", q.cost.velocity},
            {"acceleration", q.cost.acceleration},
            {"obstacle", q.cost.obstacle},
            {"total", q.cost.total()},
            {"total_at_dt_ref", plan.cost_at_dt_ref(file)}}},
          {"plan", std::move(poses)}};
}

Json times(const std::vector<double>& ms) {
  return {{"median", quantile(ms, 0.5)}, {"p99", quantile(ms, 0.99)}};
}

void print(const char* which, const Plan& plan, const std::vector<double>& ms, const SceneFile& file) {
  const BandQuality& q = plan.quality;
  std::printf(
      "  %-4s %zu bands %3zu poses %3d it  %6.2f ms (p99 %6.2f)  T %6.2f dt %.3f  h %.4f  excess v %.3f w "
      "%.3f a %.3f al %.3f  clear %.3f/%.3f  cost %.2f+%.2f+%.2f+%.2f+%.2f = %.3f, %.3f at dt_ref%s\n",
      which, plan.candidates, plan.band.size(), plan.iterations, quantile(ms, 0.5), quantile(ms, 0.99),
      q.time, plan.mean_dt(), q.max_nonholonomic, q.excess_v, q.excess_omega, q.excess_a, q.excess_alpha,
      q.clearance_poses, q.clearance_segments, q.cost.time, q.cost.nonholonomic, q.cost.velocity,
      q.cost.acceleration, q.cost.obstacle, q.cost.total(), plan.cost_at_dt_ref(file),
      plan.is_comparable(file) ? "" : "; NOT COMPARABLE: mean dt off by more than 5 %");
}

// Of one planner: figures and, if asked for, every cycle.
Json to_json(const SceneRun& run, const SceneFile& file, bool with_samples) {
  Json json = {{"count", run.warm.candidates},
               {"cold_ms", quantile(run.cold_ms, 0.5)},
               {"warm_ms", quantile(run.warm_ms, 0.5)},
               {"cold", to_json(run.cold, file)},
               {"warm", to_json(run.warm, file)}};
  if (with_samples) json["samples"] = to_json(run.samples);
  return json;
}

}  // namespace

int bench_teb(const BenchTebArguments& arguments) {
  if (arguments.repetitions < 1) throw std::runtime_error("repetitions must be at least 1");
  const SceneFile file = read_scene_file(arguments.scenes);
  Json rows = Json::array();
  for (const Scene& scene : select_scenes(file, arguments.scene)) {
    for (const BenchWeights weights : arguments.weights) {
      PlannerOptions options = options_for(file, weights, {}, 0.0);
      options.of<homotopy::HomotopyOptions>("homotopy").max_number_classes = kCandidates;
      if (arguments.adjust) arguments.adjust(options);
      const SceneRun result =
          run(scene, file, arguments.repetitions, [&] { return make_planner(arguments.planner, options); });
      const SceneRun limit = run(scene, file, arguments.repetitions,
                                 [&] { return std::make_unique<LimitPlanner>(band_of(options)); });
      const SceneRun several =
          run(scene, file, arguments.repetitions, [&] { return make_planner("teb_homotopy", options); });
      const BenchConditions conditions{weights, options, file.limits, kMaxIterations};
      std::printf("%s; %s\n", scene.name.c_str(), in_a_line(conditions).c_str());
      print("cold", result.cold, result.cold_ms, file);
      print("warm", result.warm, result.warm_ms, file);
      std::printf("  up to %d candidates (teb_homotopy)\n", kCandidates);
      print("cold", several.cold, several.cold_ms, file);
      print("warm", several.warm, several.warm_ms, file);
      std::printf("  banded limit %.2f ms cold (cost %.3f), %.2f ms warm (cost %.3f)\n",
                  quantile(limit.cold_ms, 0.5), limit.cold.quality.cost.total(), quantile(limit.warm_ms, 0.5),
                  limit.warm.quality.cost.total());
      Json row = {
          {"name", scene.name},
          {"conditions", to_json(conditions)},
          {"weights", name_of(weights)},
          {"poses", result.cold.band.size()},
          {"cold_ms", times(result.cold_ms)},
          {"warm_ms", times(result.warm_ms)},
          {"candidates", to_json(several, file, arguments.with_samples)},
          {"limit_ms", {{"cold", quantile(limit.cold_ms, 0.5)}, {"warm", quantile(limit.warm_ms, 0.5)}}},
          {"cold", to_json(result.cold, file)},
          {"warm", to_json(result.warm, file)}};
      if (arguments.with_samples) row["samples"] = to_json(result.samples);
      rows.push_back(std::move(row));
    }
  }
  write_json(arguments.json, {{"planner", arguments.planner}, {"scenes", std::move(rows)}});
  return 0;
}

}  // namespace bw
