// What is in the way: static shapes, and movers with their predicted motion. All in one planning frame
// (odom); SI units.
#pragma once

#include <cstdint>
#include <vector>

#include "runtime/base/pose2.hpp"

namespace bw {

struct Disc {
  Vector2 center{0.0, 0.0};
  double radius = 0.0;
};

struct Segment {
  Vector2 a{0.0, 0.0};
  Vector2 b{0.0, 0.0};
};

struct StaticObstacles {
  std::vector<Vector2> points;
  std::vector<Disc> discs;
  std::vector<Segment> segments;

  std::size_t size() const { return points.size() + discs.size() + segments.size(); }
};

/// Where a mover is expected `time` seconds after the problem's now, with the position covariance [m^2].
struct PredictedPosition {
  double time = 0.0;
  Vector2 position{0.0, 0.0};
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

/// From this confidence on a mover is confirmed: a person, a robot, and no piece of furniture.
inline constexpr double kConfirmed = 0.5;

/// A disc that moves. `predictions` rise in time; without them it keeps its velocity.
struct Mover {
  std::uint32_t id = 0;
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double radius = 0.3;
  double confidence = 1.0;  ///< 0 to 1: how sure it is that this is more than an obstacle
  bool reciprocal = false;  ///< known to avoid the robot by the same rule (HRVO): both share the way round
  std::vector<PredictedPosition> predictions;

  /// Position at `t` [s] from now: linear between predictions, constant velocity before the first and after
  /// the last.
  Vector2 position_at(double t) const;

  /// Largest standard deviation [m] of the position at `t` [s]: from the predictions' covariances, linear
  /// between them and growing on at the last rate; 0 without any.
  double sigma_at(double t) const;

  /// [m/s] at any time.
  double top_speed() const;
};

}  // namespace bw
