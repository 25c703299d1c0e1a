#include "components/lab/bench/corridor/corridor_scene.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "components/model/random.hpp"

namespace bw {
namespace {

/// Boxes of starts and goals along x; both as wide as the robot's corridor.
struct Stretch {
  double first, last;
};
constexpr Stretch kFromBehind{4.0, 12.0};
constexpr Stretch kFromAhead{20.0, 35.0};
constexpr double kWay = 30.0;      // [m]
constexpr double kOffRobot = 5.0;  // [m] from the robot's start
constexpr double kSpeed = 1.2;     // [m/s]
constexpr double kSpeedSigma = 0.2;
constexpr double kWallFrom = -6.5;
constexpr double kWallTo = 39.5;
constexpr double kLookahead = 8.0;  // [m] of the path that the planner is given

Vector2 place(Random& random, const Stretch& stretch) {
  const double x = random.uniform(stretch.first, stretch.last);
  return {x, random.uniform(-kCorridorHalfWidth, kCorridorHalfWidth)};
}

bool is_free(const Vector2& position, const std::vector<PedsimPerson>& there) {
  if (position.norm() < kOffRobot) return false;
  return std::none_of(there.begin(), there.end(), [&](const PedsimPerson& other) {
    return (position - other.position).norm() < 2.0 * kCorridorPersonRadius;
  });
}

PedsimPerson person(std::uint64_t seed, const std::vector<PedsimPerson>& there) {
  Random random(seed);
  PedsimPerson one;
  const bool ahead = random.uniform(0.0, 1.0) < 0.5;
  const Stretch& stretch = ahead ? kFromAhead : kFromBehind;
  do one.position = place(random, stretch);
  while (!is_free(one.position, there));
  one.goal = place(random, stretch) + Vector2(ahead ? -kWay : kWay, 0.0);
  one.other_goal = one.position;
  do one.speed = kSpeed + kSpeedSigma * random.normal();
  while (one.speed <= 0.1);
  return one;
}

}  // namespace

Limits corridor_limits() {
  return {.v_max = 2.0,
          .v_back_max = 0.01,
          .omega_max = 0.8,
          .acc_max = 2.0,
          .alpha_max = 6.0,
          .jerk_max = 100.0,
          .stop_deceleration = 3.0};
}

std::vector<PedsimPerson> corridor_people(int people, std::uint64_t seed) {
  std::vector<PedsimPerson> all;
  for (int i = 0; i < people; ++i) all.push_back(person(1000 * seed + static_cast<std::uint64_t>(i), all));
  return all;
}

DriveScene corridor_scene(int people, std::uint64_t seed) {
  DriveScene scene;
  scene.name = fmt::format("{} people seed {}", people, seed);
  std::vector<Segment> walls;
  for (const double y : {-kCorridorPeopleWalls, kCorridorPeopleWalls})
    walls.push_back({{kWallFrom, y}, {kWallTo, y}});
  scene.movers = std::make_shared<PedsimPeople>(corridor_people(people, seed), walls, kCorridorPersonRadius);
  for (const double y : {-kCorridorHalfWidth, kCorridorHalfWidth})
    scene.walls.segments.push_back({{kWallFrom, y}, {kWallTo, y}});
  scene.limits = corridor_limits();
  scene.robot_radius = kCorridorRobotRadius;
  scene.timeout = kCorridorTimeout;
  scene.unscored = kCorridorUnscored;
  scene.is_done = [](const Pose2& pose) { return pose.x > kCorridorEnd; };
  scene.path = [](const Pose2& pose) {
    return std::vector<Pose2>{{pose.x, 0.0, 0.0}, {pose.x + kLookahead, 0.0, 0.0}};
  };
  return scene;
}

}  // namespace bw
