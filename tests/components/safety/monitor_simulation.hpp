// A robot, its laser and a true world, for the property test of the collision monitor: sweeps -> CollisionMonitor -> VelocityLimiter ->
// wheels, without any middleware. A scene is a list of numbers, so that it can be drawn, made smaller, and written on one line.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "components/model/robot.hpp"
#include "components/safety/collision_monitor_options.hpp"

namespace bw::safety::test {

/// A disc of radius `p` at (x, y), or, with another end, a wall of 2 cm from (x, y) to (p, q).
struct Thing {
  double is_wall = 0.0;
  double x = 0.0;
  double y = 0.0;
  double p = 0.0;
  double q = 0.0;
};

enum Number : std::size_t {
  kShape,  ///< 0: disc of kFront; 1: rectangle from -kBack to kFront, kWidth to either side; 2: polygon of kCorners
  kFront,
  kBack,
  kWidth,
  kCorners,
  kSpeed,
  kSpeedBack,
  kTurnRate,
  kAcceleration,
  kTurnAcceleration,
  kDeceleration,
  kSeparation,
  kLaserX,
  kLaserHeading,
  kField,
  kBeams,
  kPeriod,   ///< of sweeps [s]
  kAge,      ///< of a sweep when it arrives [s]
  kNoise,    ///< of ranges, standard deviation [m]
  kDropout,  ///< share of beams that say nothing
  kRange,
  kBlindAt,  ///< a mast: directions that say nothing, around here [rad]
  kBlindWidth,
  kDarkFrom,  ///< [s]: from then on a part of the field reads +inf
  kDarkAt,
  kDarkWidth,
  kDelay,  ///< from a wheel command to the wheels [s]
  kDriver,
  kSeed,
  kSeconds,
  kCommandPeriod,  ///< [s]
  kNumbers
};

struct Scene {
  std::array<double, kNumbers> numbers{};
  std::vector<Thing> things;
};

/// On one line, and back; throws std::invalid_argument where it is none.
std::string to_text(const Scene& scene);
Scene scene_of(const std::string& line);

Scene random_scene(std::uint64_t seed);

struct Result {
  double worst = 0.0;   ///< speed at which the robot closed in on what it could see and touched it [m/s]
  double at = 0.0;      ///< [s]
  double unseen = 0.0;  ///< the same of what its laser could not see
  double driven = 0.0;  ///< way of base_link [m]
};
Result run(const Scene& scene);

/// The least scene found that still is worse than `speed`.
Scene shrunk(Scene scene, double speed);

}  // namespace bw::safety::test
