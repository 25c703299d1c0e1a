// Experiment E5 (protocols.md 8.5): a robot drives from left to right, two people cross its path and do not
// react.
// Metres, seconds, radians.
//
//   robot (0, 0) -> (10, 0), v_max 1, acc_max 0.5, radius 0.3
//   A from (4.0, -4.2 + J) upwards with 1 m/s, the left one in the picture, who is met first
//   B from (6.5, 6.6 + J) downwards with 1 m/s          J uniform in [-0.5, 0.5], one draw each per seed
//
// That was proposed. There the robot comes too late to pass in front of anybody: TEB passes behind A and B in
// 40 of 40 runs. One shift is allowed: both start 1 m farther away. TEB (people known to move) then passes in
// front of A in 35 of 40 runs, against exactly half of them with 0.8 m.
#pragma once

#include <cstdint>
#include <vector>

#include "components/lab/bench/scene_file.hpp"
#include "components/lab/experiments/passing.hpp"

namespace bw {

/// Where the two people start without jitter; both walk straight with 1 m/s. The default is shifted.
struct CrossingGeometry {
  Vector2 a{4.0, -5.2};
  Vector2 b{6.5, 7.6};
};

/// As proposed.
inline CrossingGeometry proposed_crossing() { return {{4.0, -4.2}, {6.5, 6.6}}; }

/// Limits and the rule of the drive: the closed loop of the crowd scenes with acc_max 0.5 m/s^2, without
/// walls that mirror.
SceneFile crossing_rules();

/// Obstacles are A, then B.
Scene crossing_scene(const CrossingGeometry& geometry, std::uint64_t seed);

StraightWalk walk_of(const SceneObstacle& person);

}  // namespace bw
