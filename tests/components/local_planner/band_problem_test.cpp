// The optimiser's residuals against the independent judge of the benchmark rules, and its solutions against
// another solver.
#include "components/local_planner/teb/band_problem.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "components/lab/bench/band_evaluator.hpp"
#include "components/lab/bench/bench.hpp"
#include "components/model/random.hpp"
#include "tests/components/local_planner/band_scenes.hpp"

namespace bw::teb {
namespace {

constexpr std::uint64_t kSeed = 22;

SceneFile rules() {
  SceneFile file;
  file.limits.v_max = 0.4;
  file.limits.omega_max = 0.3;
  file.limits.acc_max = file.limits.alpha_max = 0.5;
  file.dt_ref = 0.3;
  file.dt_hysteresis = 0.1;
  file.min_dist = 0.5;
  file.inflation_dist = file.dynamic_inflation_dist = 0.6;
  file.weights = {2, 1, 1, 1, 1000, 1, 1, 50, 0.1, 50, 0.1, 0.05};
  return file;
}

std::vector<SceneObstacle> random_obstacles(Random& random) {
  std::vector<SceneObstacle> obstacles;
  for (int j = 0; j < 8; ++j) {
    SceneObstacle o;
    o.position = {random.uniform(0.0, 4.0), random.uniform(-1.0, 1.0)};
    o.radius = j % 3 == 0 ? 0.0 : random.uniform(0.0, 0.3);
    if (j % 2 == 0) o.velocity = {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
    obstacles.push_back(o);
  }
  return obstacles;
}

ObstacleField field_of(const std::vector<SceneObstacle>& obstacles) {
  ObstacleField field;
  std::vector<Capsule> statics;
  for (const SceneObstacle& o : obstacles) {
    if (o.moves()) {
      Mover m;
      m.position = o.position;
      m.velocity = o.velocity;
      m.radius = o.radius;
      field.movers.push_back(m);
    } else {
      statics.push_back({o.position, o.position, o.radius});
    }
  }
  field.statics = CapsuleIndex(statics);
  return field;
}

TEST(BandProblem, CostEqualsTheJudgeOfTheBenchmarkRules) {
  Random random(kSeed);
  const SceneFile file = rules();
  BandOptions options = band_of(options_for(file, BenchWeights::file, {}, 0.0));
  options.max_obstacles_per_pose = 100;
  options.clearance_step = 10.0;  // the rules judge obstacles at poses only
  for (int i = 0; i < 200; ++i) {
    Band band;
    std::vector<EvaluatedPose> judged;
    for (int k = 0; k < 20; ++k) {
      const BandPose p{0.2 * k + random.uniform(-0.15, 0.15), random.uniform(-0.2, 0.2),
                       random.uniform(-2.0, 2.0), k < 19 ? random.uniform(0.05, 0.5) : 0.0};
      band.poses.push_back(p);
      judged.push_back({p.pose(), p.dt});
    }
    const std::vector<SceneObstacle> obstacles = random_obstacles(random);
    const ObstacleField field = field_of(obstacles);
    const Twist2 start{random.uniform(-0.2, 0.5), random.uniform(-0.3, 0.3)};
    const BandProblem problem(band, {file.limits, start, true, &field}, options, 1.0);
    const BandCost cost = problem.cost(band.poses.data());
    const BandCosts expected = evaluate_band(judged, start, file, obstacles).cost;
    EXPECT_NEAR(cost.obstacle, expected.obstacle, 1e-9 * (1.0 + expected.obstacle))
        << "seed " << kSeed << " case " << i;
    EXPECT_NEAR(cost.total(), expected.total(), 1e-9 * expected.total()) << "seed " << kSeed << " case " << i;
  }
}

class Optimize : public testing::TestWithParam<Solver> {};
INSTANTIATE_TEST_SUITE_P(Solvers, Optimize, testing::Values(Solver::ceres, Solver::banded),
                         [](const auto& solver) { return std::string(text_of(solver.param)); });

TEST_P(Optimize, LowersTheCostOfEveryScene) {
  Random random(kSeed);
  const SceneFile file = rules();
  BandOptions options = band_of(options_for(file, BenchWeights::file, {}, 0.0));
  options.solver = GetParam();
  options.weight_adapt_factor = 1.0;  // growing weights trade the other costs for clearance
  for (int i = 0; i < 50; ++i) {
    const ObstacleField field = field_of(random_obstacles(random));
    Band band = band_along({{0, 0, 0}, {4, 0.5, 0}}, {0, 0, 0}, file.limits, options);
    const BandScene scene{file.limits, {}, true, &field};
    const double before = BandProblem(band, scene, options, 1.0).cost(band.poses.data()).total();
    const BandReport report = optimize(band, scene, options, 100);
    ASSERT_TRUE(report.usable);
    EXPECT_LT(report.cost, before) << "seed " << kSeed << " case " << i;
    EXPECT_LE(report.iterations, 100);
    EXPECT_EQ(band.poses.front().pose(), (Pose2{0, 0, 0}));
    EXPECT_EQ(band.poses.back().pose(), (Pose2{4, 0.5, 0}));
  }
}

TEST(Solvers, FindOneMinimum) {
  // Both solvers start from one band a hundred iterations from cold, association frozen: one minimum,
  // relative difference <= 1e-3.
  Random random(kSeed);
  const SceneFile file = rules();
  BandOptions options = band_of(options_for(file, BenchWeights::file, {}, 0.0));
  options.weight_adapt_factor = 1.0;
  options.function_tolerance = 1e-10;
  options.warm_outer_iterations = 1;
  options.warm_inner_iterations = 200;
  options.no_outer_iterations = 8;
  options.no_inner_iterations = 20;
  for (int i = 0; i < 20; ++i) {
    std::vector<SceneObstacle> obstacles = random_obstacles(random);
    for (SceneObstacle& o : obstacles) {
      o.velocity = {0.0, 0.0};
      o.position.y() += o.position.y() > 0.0 ? 0.5 : -0.5;  // a path through the middle
    }
    const ObstacleField field = field_of(obstacles);
    const BandScene scene{file.limits, {}, true, &field};
    Band band = band_along({{0, 0, 0}, {4, 0.0, 0}}, {-0.5, 0, 0}, file.limits, options);
    ASSERT_TRUE(optimize(band, scene, options, 1000).usable);
    resize(band, options);
    Band other = band;
    const BandReport by_ceres = optimize(band, scene, options, 1000);
    options.solver = Solver::banded;
    const BandReport by_hand = optimize(other, scene, options, 1000);
    options.solver = Solver::ceres;
    ASSERT_TRUE(by_ceres.usable && by_hand.usable);
    EXPECT_NEAR(by_ceres.cost, by_hand.cost, 1e-3 * by_hand.cost) << "seed " << kSeed << " case " << i;
  }
}

TEST(Solvers, ReachTheSameCostColdAndWarm) {
  // From one band each, a first plan and the 20 cycles after it. A last step that gains less than
  // function_tolerance 1e-4 of the cost counts with one solver and not with the other; growing weights and
  // dampings multiply that a little.
  for (const BandTestScene& scene : band_scenes()) {
    for (const bool consistent : {false, true}) {
      BandOptions options = point_options();
      options.consistent_motion = consistent;
      BandDrive drive(scene, options);
      for (int cycle = 0; cycle <= 20; ++cycle) {
        Band by_hand = drive.next();
        Band by_ceres = by_hand;
        options.solver = Solver::ceres;
        const BandReport ceres = optimize(by_ceres, drive.scene_now, options, 1000);
        options.solver = Solver::banded;
        const BandReport banded = optimize(by_hand, drive.scene_now, options, 1000);
        ASSERT_TRUE(ceres.usable && banded.usable) << scene.name << " cycle " << cycle;
        EXPECT_NEAR(ceres.cost, banded.cost, 5e-3 * banded.cost) << scene.name << " cycle " << cycle;
        drive.band = by_hand;
      }
    }
  }
}

TEST_P(Optimize, SpendsNoMoreThanItsBudget) {
  const SceneFile file = rules();
  BandOptions options = band_of(options_for(file, BenchWeights::file, {}, 0.0));
  options.solver = GetParam();
  const ObstacleField none;
  Band band = band_along({{0, 0, 0}, {4, 1.5, 1}}, {0, 0, 0}, file.limits, options);
  EXPECT_LE(optimize(band, {file.limits, {}, true, &none}, options, 3).iterations, 3);
}

}  // namespace
}  // namespace bw::teb
