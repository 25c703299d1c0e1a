// Floors, a scanner and drives for tests of SLAM.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "components/model/laser_sweep.hpp"
#include "components/model/random.hpp"
#include "components/slam/scan.hpp"
#include "components/slam/surface_map.hpp"
#include "components/world/laser_scanner.hpp"
#include "components/world/static_scene.hpp"

namespace bw::slam::test {

inline void add_box(StaticObstacles& shapes, const Vector2& low, const Vector2& high) {
  const Vector2 right{high.x(), low.y()};
  const Vector2 left{low.x(), high.y()};
  shapes.segments.push_back({low, right});
  shapes.segments.push_back({right, high});
  shapes.segments.push_back({high, left});
  shapes.segments.push_back({left, low});
}

/// Four walls about the origin.
inline StaticObstacles room(double width, double height) {
  StaticObstacles shapes;
  add_box(shapes, {-0.5 * width, -0.5 * height}, {0.5 * width, 0.5 * height});
  return shapes;
}

/// Corridors 2 m wide in a square about a block of 8 x 6 m, with a cupboard and a pillar, so that no two
/// sides are alike. The middle of the corridors: x = +-5, y = +-4.
inline StaticObstacles square_of_corridors() {
  StaticObstacles shapes = room(12.0, 10.0);
  add_box(shapes, {-4.0, -3.0}, {4.0, 3.0});
  add_box(shapes, {1.0, -5.0}, {2.2, -4.6});
  add_box(shapes, {-6.0, 1.0}, {-5.6, 1.8});
  add_box(shapes, {4.0, -1.0}, {4.2, -0.2});
  shapes.discs.push_back({{-1.5, 4.8}, 0.2});
  return shapes;
}

/// What a scanner on base_link measures.
class Scanner {
 public:
  Scanner(const StaticObstacles& shapes, double noise, std::uint64_t seed, const LaserOptions& laser = {})
      : laser_(laser), scene_(shapes, std::nullopt), scanner_(with_noise(laser, noise), Random(seed)) {}

  /// The ranges live until the next one.
  LaserSweep sweep(Time time, const Pose2& X_MB) {
    scan_ = scanner_.scan(scene_, {}, X_MB);
    return {.time = time,
            .X_FL = {},
            .angle_min = scan_.angle_min,
            .angle_increment = scan_.angle_increment,
            .range_min = 0.05,
            .range_max = laser_.range_max,
            .ranges = scan_.ranges};
  }
  Scan scan(Time time, const Pose2& X_MB, const SlamOptions& options = {}) {
    return scan_of(sweep(time, X_MB), options);
  }

 private:
  static LaserOptions with_noise(LaserOptions laser, double noise) {
    laser.range_noise = noise;
    return laser;
  }
  LaserOptions laser_;
  StaticScene scene_;
  LaserScanner scanner_;
  LaserScan scan_;
};

/// Poses every `step` [m] along straight lines between corners, with turns on the spot in steps of 0.1 rad.
inline std::vector<Pose2> drive_along(std::span<const Vector2> corners, double step) {
  std::vector<Pose2> poses;
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Vector2 way = corners[k] - corners[k - 1];
    const double heading = std::atan2(way.y(), way.x());
    if (!poses.empty()) {
      const Pose2 at = poses.back();
      const double turn = wrap_angle(heading - at.theta);
      const int turns = static_cast<int>(std::ceil(std::abs(turn) / 0.1));
      for (int i = 1; i <= turns; ++i) poses.push_back({at.x, at.y, wrap_angle(at.theta + turn * i / turns)});
    }
    const int steps = static_cast<int>(std::round(way.norm() / step));
    for (int i = poses.empty() ? 0 : 1; i <= steps; ++i) {
      const Vector2 p = corners[k - 1] + way * (static_cast<double>(i) / steps);
      poses.push_back({p.x(), p.y(), heading});
    }
  }
  return poses;
}

/// X_OB of odometry whose travel and turns are too long by these shares.
inline std::vector<Pose2> odometry_of(std::span<const Pose2> X_MB, double travel_off, double turn_off) {
  std::vector<Pose2> X_OB{{}};
  for (std::size_t k = 1; k < X_MB.size(); ++k) {
    const Pose2 step = inverse(X_MB[k - 1]) * X_MB[k];
    X_OB.push_back(X_OB.back() * Pose2{step.x * (1.0 + travel_off), step.y * (1.0 + travel_off),
                                       step.theta * (1.0 + turn_off)});
  }
  return X_OB;
}

inline double distance(const Pose2& a, const Pose2& b) { return std::hypot(a.x - b.x, a.y - b.y); }

inline Pose2 random_pose(Random& random, double metres, double radians) {
  return {random.uniform(-metres, metres), random.uniform(-metres, metres),
          random.uniform(-radians, radians)};
}

}  // namespace bw::slam::test
