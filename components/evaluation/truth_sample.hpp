// One look at the world's truth. Poses and velocities in map.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "runtime/base/pose2.hpp"
#include "runtime/base/time.hpp"

namespace bw {

/// Bodies farther apart are no longer in contact [m].
inline constexpr double kBodiesApart = 0.02;

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

/// Whether the positions of everybody can be reckoned with.
inline bool is_sound(const TruthSample& sample) {
  return sample.X_MB.position().allFinite() && !std::isnan(sample.wall_gap) &&
         std::all_of(sample.people.begin(), sample.people.end(), [](const TruePerson& person) {
           return person.position.allFinite() && std::isfinite(person.radius);
         });
}

}  // namespace bw
