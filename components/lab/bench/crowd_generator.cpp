#include "components/lab/bench/crowd_generator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr int kStaticDiscs = 6;
constexpr double kStaticGap = 1.6;     // [m] edge to edge
constexpr double kFreeAtStart = 1.5;   // [m] start to edge
constexpr double kWalkerGap = 0.1;     // [m] edge to edge, in dense crowds
constexpr double kWalkerRadius = 0.3;  // [m]
constexpr std::array<int, 3> kWalkers = {6, 10, 14};
constexpr int kMaxTries = 10'000;

double two_decimals(double value) { return std::round(100.0 * value) / 100.0; }

Vector2 draw_position(Random& random, double x_min, double x_max, double y_max) {
  const double x = two_decimals(random.uniform(x_min, x_max));
  const double y = two_decimals(random.uniform(-y_max, y_max));
  return {x, y};
}

bool keeps_gap(const SceneObstacle& disc, const std::vector<SceneObstacle>& others, double gap) {
  return std::all_of(others.begin(), others.end(), [&](const SceneObstacle& other) {
    return (disc.position - other.position).norm() - disc.radius - other.radius >= gap;
  });
}

// Six discs; empty when the first ones left no room for the rest.
std::vector<SceneObstacle> try_static_discs(Random& random) {
  std::vector<SceneObstacle> discs;
  for (int attempt = 0; attempt < kMaxTries; ++attempt) {
    SceneObstacle disc;
    disc.position = draw_position(random, 2.0, 10.4, 3.5);
    disc.radius = random.uniform() < 0.5 ? 0.2 : 0.3;
    if (keeps_gap(disc, discs, kStaticGap)) discs.push_back(disc);
    if (discs.size() == kStaticDiscs) return discs;
  }
  return {};
}

SceneObstacle draw_walker(Random& random, const Vector2& start) {
  SceneObstacle walker;
  walker.radius = kWalkerRadius;
  do {
    walker.position = draw_position(random, -0.5, 12.5, 3.8);
  } while ((walker.position - start).norm() - walker.radius < kFreeAtStart);
  const double speed = random.uniform(0.3, 1.2);
  const double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
  walker.velocity = {two_decimals(speed * std::cos(heading)), two_decimals(speed * std::sin(heading))};
  return walker;
}

Scene scene_with_discs(std::uint64_t seed, int walkers, Random& random) {
  Scene scene;
  scene.name = "seed" + std::to_string(seed) + "_" + std::to_string(walkers);
  scene.goal = {12.0, 0.0, 0.0};
  while (scene.obstacles.empty()) scene.obstacles = try_static_discs(random);
  return scene;
}

template <class Generate>
std::vector<Scene> scenes_of(int count, std::uint64_t first_seed, const Generate& generate) {
  if (count < 0) throw std::runtime_error("the number of scenes must not be negative");
  std::vector<Scene> scenes;
  scenes.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) scenes.push_back(generate(first_seed + static_cast<std::uint64_t>(i)));
  return scenes;
}

}  // namespace

SceneFile crowd_rules() {
  SceneFile file;
  file.replan_period = 0.1;
  file.warm_cycles = 1;
  file.limits.v_max = 1.0;
  file.limits.v_back_max = 0.2;
  file.limits.omega_max = 1.0;
  file.limits.acc_max = 1.0;
  file.limits.alpha_max = 1.5;
  file.limits.stop_deceleration = std::max(file.limits.stop_deceleration, file.limits.acc_max);
  file.dt_ref = 0.3;
  file.dt_hysteresis = 0.1;
  file.min_dist = 0.5;
  file.inflation_dist = 0.6;
  file.dynamic_inflation_dist = 0.6;
  file.weights = {.max_vel_x = 2,
                  .max_vel_theta = 1,
                  .acc_lim_x = 1,
                  .acc_lim_theta = 1,
                  .kinematics_nh = 1000,
                  .forward_drive = 1,
                  .time = 1,
                  .obstacle = 50,
                  .inflation = 0.1,
                  .dynamic_obstacle = 50,
                  .dynamic_inflation = 0.1,
                  .penalty_epsilon = 0.05};
  file.closed_loop = ClosedLoop{.control_period = 0.1,
                                .timeout = 60.0,
                                .goal_tolerance = 0.3,
                                .robot_radius = 0.3,
                                .box = {-1.0, 13.0, -4.0, 4.0}};
  return file;
}

Scene generate_crowd_scene(std::uint64_t seed) {
  Random random(seed);
  const int walkers = kWalkers[seed % kWalkers.size()];
  Scene scene = scene_with_discs(seed, walkers, random);
  for (int i = 0; i < walkers; ++i) scene.obstacles.push_back(draw_walker(random, scene.start.position()));
  return scene;
}

Scene generate_dense_crowd_scene(std::uint64_t seed, double density) {
  if (!(density > 0.0 && density <= 1.0))
    throw std::runtime_error("the density must be above 0, and at most 1 person per square metre");
  const SceneBox box = crowd_rules().closed_loop->box;
  const double area = (box.x_max - box.x_min) * (box.y_max - box.y_min);
  const int walkers = static_cast<int>(std::lround(density * area));
  Random random(seed);
  Scene scene = scene_with_discs(seed, walkers, random);
  for (int i = 0; i < walkers;) {
    const SceneObstacle walker = draw_walker(random, scene.start.position());
    if (!keeps_gap(walker, scene.obstacles, kWalkerGap)) continue;
    scene.obstacles.push_back(walker);
    ++i;
  }
  return scene;
}

std::vector<Scene> generate_crowd(int count, std::uint64_t first_seed) {
  return scenes_of(count, first_seed, generate_crowd_scene);
}

std::vector<Scene> generate_dense_crowd(int count, std::uint64_t first_seed, double density) {
  return scenes_of(count, first_seed,
                   [density](std::uint64_t seed) { return generate_dense_crowd_scene(seed, density); });
}

}  // namespace bw
