// One look at the world's truth. Poses and velocities in map.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

struct TruePerson {
  std::uint32_t id = 0;
  Vector2 position{0.0, 0.0};
  Vector2 velocity{0.0, 0.0};
  double radius = 0.3;  ///< [m]
};

struct TruthSample {
  Time time;
  Pose2 X_MB;
  Twist2 twist;
  std::vector<TruePerson> people;
  double wall_gap =
      std::numeric_limits<double>::infinity();  ///< from the robot's rim to the nearest wall [m]
  std::uint32_t contacts = 0;                   ///< counted by the world since its start
};

}  // namespace bw
