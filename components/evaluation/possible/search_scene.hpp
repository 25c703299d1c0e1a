// What a search for a motion is told: who walks where, what stands where, what the robot can do. All in one
// frame that does not move (map); SI units.
#pragma once

#include <optional>
#include <vector>

#include "components/model/limits.hpp"
#include "components/model/obstacles.hpp"
#include "runtime/base/pose2.hpp"

namespace bw::possible {

struct TimedPosition {
  double time = 0.0;  ///< [s]
  Vector2 position{0.0, 0.0};
};

/// Somebody who walks as they did, whatever the robot does: linear between positions, nowhere before the
/// first and after the last. Times of `positions` rise.
struct Walk {
  double radius = 0.3;  ///< [m]
  std::vector<TimedPosition> positions;

  std::optional<Vector2> at(double time) const;
};

struct SearchScene {
  std::vector<Walk> walks;
  StaticObstacles shapes;
  std::vector<Vector2> squares;  ///< centres of occupied cells of a map
  double square_edge = 0.0;      ///< of each [m]
  double outer_radius = 0.3;     ///< of the disc around the robot [m]
  double inner_radius = 0.3;     ///< of the largest disc around base_link in its footprint [m]
};

/// Where a robot was and how it moved.
struct MotionState {
  double time = 0.0;  ///< [s]
  Pose2 pose;
  Twist2 twist;
};

/// What a motion may use. Magnitudes.
struct MotionBounds {
  double v_max = 1.0;         ///< [m/s]
  double v_back_max = 0.2;    ///< [m/s]
  double omega_max = 1.0;     ///< [rad/s]
  double acceleration = 1.0;  ///< and deceleration [m/s^2]
  double alpha = 1.5;         ///< [rad/s^2]
};

/// `factor` on the accelerations, which never fall below the deceleration of a safety stop where it is above
/// 1.
MotionBounds bounds_of(const Limits& limits, double factor);

}  // namespace bw::possible
