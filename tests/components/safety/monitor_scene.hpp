// A scene of the collision monitor's property test: a robot, its laser, its driver, things that stand and
// people who walk, as a list of numbers, so that it can be drawn, made smaller, and written on one line.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "components/model/footprint_distance.hpp"
#include "components/model/robot.hpp"

namespace bw::safety::test {

/// A disc of radius `p` at (x, y), or, with another end, a wall of 2 cm from (x, y) to (p, q). It moves with
/// (vx, vy) until `until` seconds have gone, and stands then.
struct Thing {
  double is_wall = 0.0;
  double x = 0.0;
  double y = 0.0;
  double p = 0.0;
  double q = 0.0;
  double vx = 0.0;
  double vy = 0.0;
  double until = 0.0;

  double speed() const { return std::hypot(vx, vy); }
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
  kAngularAcceleration,
  kDeceleration,
  kSeparation,
  kLaserX,
  kLaserHeading,
  kField,
  kBeams,
  kPeriod,   ///< of sweeps [s]
  kAge,      ///< of a sweep's last beam when it arrives [s]
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
  kSweepShare,     ///< share of a period in which a head that rotates takes its beams; 0: all at once
  kClock,          ///< what the laser's clock is ahead of the robot's [s]; 0: it is the robot's own
  kDrift,          ///< of another clock [s/s]
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

Robot robot_of(const Scene& scene);
Capsule shape_of(const Thing& thing, double t);
/// At the start, from the robot.
bool is_apart(const Footprint& outline, const Thing& thing);

}  // namespace bw::safety::test
