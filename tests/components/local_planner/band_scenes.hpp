// Scenes like those of `bandwagon bench teb`, made in code: a short corridor with few obstacles, a field of
// 20, the same with every second one moving, and walls and boxes as 200 points. Shared by the tests and the
// benchmark of the solvers.
#pragma once

#include <string>
#include <vector>

#include "components/local_planner/teb/band_optimizer.hpp"
#include "components/model/random.hpp"

namespace bw::teb {

struct BandTestScene {
  std::string name;
  Pose2 goal;
  StaticObstacles statics;
  std::vector<Mover> movers;
};

inline Limits slow_limits() {
  Limits limits;
  limits.v_max = 0.4;
  limits.v_back_max = 0.2;
  limits.omega_max = 0.3;
  limits.acc_max = limits.alpha_max = 0.5;
  return limits;
}

/// The robot is a point that keeps 0.5 m.
inline BandOptions point_options() {
  BandOptions options;
  options.min_obstacle_dist = 0.5;
  options.inflation_dist = options.dynamic_obstacle_inflation_dist = 0.6;
  options.narrow_passage_dist = options.min_obstacle_dist;
  return options;
}

inline std::vector<BandTestScene> band_scenes() {
  BandTestScene corridor{"corridor", {6.0, 0.0, 0.0}, {}, {}};
  corridor.statics.points = {{1.2, 0.42}, {3.2, 0.48}, {5.0, 0.45}};
  corridor.statics.discs = {{{2.3, -0.62}, 0.15}, {{4.1, -0.58}, 0.2}};
  BandTestScene field{"field", {10.0, 0.0, 0.0}, {}, {}}, moving{"moving", {10.0, 0.0, 0.0}, {}, {}};
  Random random(31);
  for (int i = 0; i < 20; ++i) {
    // A raster of 5 x 4, each up to 0.3 m away from its position.
    const double x = 1.4 + 1.8 * (i % 5) + random.uniform(-0.3, 0.3);
    const double y = -2.4 + 1.6 * static_cast<double>(i / 5) + random.uniform(-0.3, 0.3);
    const double radius = i % 3 == 0 ? 0.0 : random.uniform(0.1, 0.3);
    field.statics.discs.push_back({{x, y}, radius});
    if (i % 2 == 0) {
      moving.statics.discs.push_back(field.statics.discs.back());
      continue;
    }
    Mover mover;
    mover.id = static_cast<std::uint32_t>(i);
    mover.position = {x, y};
    mover.velocity = random.uniform(0.15, 0.6) * direction(random.uniform(-3.14, 3.14));
    mover.radius = radius;
    moving.movers.push_back(mover);
  }
  BandTestScene walls{"walls", {10.0, 0.0, 0.0}, {}, {}};
  for (int i = 0; i < 66; ++i) {
    walls.statics.points.emplace_back(0.5 + 0.15 * i, 1.7 + 0.1 * std::sin(0.1 * i));
    walls.statics.points.emplace_back(0.5 + 0.15 * i, -1.7 + 0.1 * std::sin(0.13 * i));
  }
  for (int i = 0; i < 68; ++i) {
    // Three boxes of 0.7 x 0.8 m against the walls, by their outlines.
    const Vector2 box[] = {{2.2, 1.2}, {5.0, -1.2}, {7.6, 1.2}};
    const double along = 3.0 * (i / 3) / 22.0 - 1.5;
    const Vector2 on = std::abs(along) < 0.75
                           ? Vector2(along * 0.35 / 0.75, box[i % 3].y() > 0.0 ? -0.4 : 0.4)
                           : Vector2(along > 0.0 ? 0.35 : -0.35, 0.8 * std::abs(along) - 1.0);
    walls.statics.points.push_back(box[i % 3] + on);
  }
  return {corridor, field, moving, walls};
}

/// What a planner of one band does in a cycle around the solve, the band driven as planned.
class BandDrive {
 public:
  BandDrive(const BandTestScene& scene, BandOptions options) : scene_(scene), options_(options) {}

  /// The band of the next cycle, 0.1 s after the last one, and what it keeps clear of, ready for optimize().
  Band next() {
    if (band.empty()) return prepared({});
    const Pose2 pose = band.pose_at(kPeriod);
    const BandPose& a = band.poses[0];
    const BandPose& b = band.poses[1];
    scene_now.start_twist = {(b.position() - a.position()).dot(direction(a.theta)) / a.dt,
                             wrap_angle(b.theta - a.theta) / a.dt};
    for (Mover& mover : scene_.movers) mover.position += kPeriod * mover.velocity;
    return prepared(pose);
  }

  Band band;  ///< the last one optimised: to be set by the caller
  BandScene scene_now{.limits = slow_limits(), .start_twist = {}, .goal_at_rest = true, .obstacles = &field_};

 private:
  static constexpr double kPeriod = 0.1;  // [s]

  Band prepared(const Pose2& pose) {
    field_ = field_of(scene_.statics, scene_.movers, pose.position(), {.radius = 0.0, .polygon = {}});
    if (band.empty()) return band_along({pose, scene_.goal}, pose, scene_now.limits, options_);
    Band next = band;
    advance(next, pose, 1.0, options_);
    return next;
  }

  BandTestScene scene_;
  BandOptions options_;
  ObstacleField field_;
};

}  // namespace bw::teb
