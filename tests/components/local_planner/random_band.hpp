// Short bands among obstacles of every kind, for tests of what the solvers see.
#pragma once

#include "components/local_planner/teb/band_optimizer.hpp"
#include "components/model/random.hpp"

namespace bw::teb {

/// 3 to 6 poses near the x axis, 6 standing and 6 moving obstacles beside them, tight limits; motion model
/// and end by turns with `i`.
struct RandomBand {
  RandomBand(Random& random, int i, const Footprint& footprint) {
    const std::size_t count = 3 + static_cast<std::size_t>(i % 4);
    for (std::size_t k = 0; k < count; ++k) {
      const double x = 0.35 * static_cast<double>(k) + random.uniform(-0.1, 0.1);
      const double y = random.uniform(-0.2, 0.2), theta = random.uniform(-0.8, 0.8);
      band.poses.push_back({x, y, theta, k + 1 < count ? random.uniform(0.1, 0.6) : 0.0});
    }
    field.footprint = footprint;
    std::vector<Capsule> statics;
    for (int j = 0; j < 6; ++j) {
      const Vector2 a(random.uniform(0.0, 1.5), random.uniform(-0.6, 0.6));
      const Vector2 b = j % 2 == 0 ? a : Vector2(a + Vector2(0.3, random.uniform(-0.3, 0.3)));
      statics.push_back({a, b, random.uniform(0.0, 0.2)});
      Mover mover;
      mover.position = {random.uniform(0.0, 1.5), random.uniform(-1.0, 1.0)};
      mover.velocity = {random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
      field.movers.push_back(mover);
    }
    field.statics = CapsuleIndex(statics);
    options.consistent_motion = i % 2 == 0;
    options.clearance_step = 0.1;
    scene.limits.v_max = 0.4;
    scene.limits.omega_max = 0.3;
    scene.limits.acc_max = scene.limits.alpha_max = 0.5;
    scene.start_twist = {random.uniform(-0.2, 0.5), random.uniform(-0.3, 0.3)};
    scene.goal_at_rest = i % 3 != 0;
    scene.obstacles = &field;
  }
  RandomBand(const RandomBand&) = delete;

  /// Variable v % 4 of pose v / 4.
  static double& variable(Band& band, std::size_t v) { return (&band.poses[v / 4].x)[v % 4]; }
  double variable(std::size_t v) { return variable(band, v); }

  Band band;
  ObstacleField field;
  BandOptions options;
  BandScene scene;
};

}  // namespace bw::teb
