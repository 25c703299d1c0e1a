#include "components/lab/experiments/crossing_scene.hpp"

#include "components/lab/bench/crowd_generator.hpp"
#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr double kJitter = 0.5;        // [m]
constexpr double kPersonRadius = 0.3;  // [m]
constexpr double kFar = 1000.0;        // [m] nobody gets there before the timeout

}  // namespace

SceneFile crossing_rules() {
  SceneFile file = crowd_rules();
  file.limits.acc_max = 0.5;
  file.closed_loop->box = {-kFar, kFar, -kFar, kFar};
  return file;
}

Scene crossing_scene(const CrossingGeometry& geometry, std::uint64_t seed) {
  Random random(seed);
  const double shift_a = random.uniform(-kJitter, kJitter);
  const double shift_b = random.uniform(-kJitter, kJitter);
  Scene scene;
  scene.name = "seed" + std::to_string(seed);
  scene.goal = {10.0, 0.0, 0.0};
  scene.obstacles = {{geometry.a + Vector2(0.0, shift_a), kPersonRadius, {0.0, 1.0}},
                     {geometry.b + Vector2(0.0, shift_b), kPersonRadius, {0.0, -1.0}}};
  return scene;
}

StraightWalk walk_of(const SceneObstacle& person) { return {person.position, person.velocity}; }

}  // namespace bw
