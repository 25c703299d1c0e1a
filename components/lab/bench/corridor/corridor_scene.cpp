#include "components/lab/bench/corridor/corridor_scene.hpp"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "components/lab/bench/scene_actors.hpp"
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

constexpr Stretch kAcross{-kCorridorHalfWidth, kCorridorHalfWidth};

Vector2 place(Random& random, const Stretch& along, const Stretch& across = kAcross) {
  const double x = random.uniform(along.first, along.last);
  return {x, random.uniform(across.first, across.last)};
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

namespace {

// Somebody of a box who walks towards another place of it, `across` further on along y, and on for ever.
struct StraightRule {
  Stretch x, y;
  double across;
  double speed, sigma;  // [m/s]
};

StraightRule straight_rule(int people) {
  if (people <= 4) return {{1.0, 10.0}, kAcross, 0.0, 1.1, 0.1};
  return {{4.0, 20.0}, kAcross, 0.0, 1.4, 0.26};
}

// Three sidewalks.
const std::array kSidewalks{StraightRule{{8.0, 10.0}, {-10.0, -3.0}, 40.0, 0.85, 0.15},
                            StraightRule{{14.0, 16.0}, {6.0, 14.0}, -40.0, 0.85, 0.15},
                            StraightRule{{22.0, 24.0}, {10.0, 15.0}, -40.0, 0.85, 0.15}};

SceneActor straight(std::size_t id, const Vector2& from, const Vector2& to, double speed) {
  return {{.id = static_cast<std::uint32_t>(id),
           .position = from,
           .velocity = speed * (to - from).normalized(),
           .radius = kCorridorPersonRadius}};
}

SceneActor draw(const StraightRule& rule, std::size_t id, Random& random) {
  const Vector2 from = place(random, rule.x, rule.y);
  const Vector2 to = place(random, rule.x, rule.y) + Vector2(0.0, rule.across);
  return straight(id, from, to, std::max(0.1, random.normal(rule.speed, rule.sigma)));
}

DriveScene corridor_of(std::string name, std::shared_ptr<const SceneMovers> movers) {
  DriveScene scene;
  scene.name = std::move(name);
  scene.movers = std::move(movers);
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

}  // namespace

DriveScene corridor_scene(int people, std::uint64_t seed) {
  std::vector<Segment> walls;
  for (const double y : {-kCorridorPeopleWalls, kCorridorPeopleWalls})
    walls.push_back({{kWallFrom, y}, {kWallTo, y}});
  return corridor_of(
      fmt::format("{} people seed {}", people, seed),
      std::make_shared<PedsimPeople>(corridor_people(people, seed), walls, kCorridorPersonRadius));
}

DriveScene straight_corridor_scene(int people, std::uint64_t seed) {
  Random random(seed);
  std::vector<SceneActor> actors;
  for (int i = 0; i < people; ++i) actors.push_back(draw(straight_rule(people), actors.size(), random));
  return corridor_of(fmt::format("{} people seed {}", people, seed), std::make_shared<SceneActors>(actors));
}

DriveScene crossing_scene(std::uint64_t seed) {
  Random random(seed);
  std::vector<SceneActor> actors;
  for (int i = 0; i < kCrossingPeople; ++i)
    actors.push_back(draw(kSidewalks[random.bits() % kSidewalks.size()], actors.size(), random));
  return corridor_of(fmt::format("crossing seed {}", seed), std::make_shared<SceneActors>(actors));
}

std::vector<DriveScene> fixed_crossings() {
  using Way = std::pair<Vector2, Vector2>;
  const std::vector<std::tuple<const char*, double, std::vector<Way>>> all = {
      {"1_left", 1.0, {{{3.0, -2.5}, {3.0, 3.0}}}},
      {"2_opposite_crossing", 1.0, {{{3.0, -2.5}, {3.0, 3.0}}, {{4.5, 2.5}, {4.5, -3.0}}}},
      {"3_lrl", 1.3, {{{3.5, 3.0}, {3.5, -3.0}}, {{7.2, -8.0}, {7.2, 3.0}}, {{12.0, 9.0}, {12.0, -3.0}}}}};
  std::vector<DriveScene> scenes;
  for (const auto& [name, speed, ways] : all) {
    std::vector<SceneActor> actors;
    for (const auto& [from, to] : ways) actors.push_back(straight(actors.size(), from, to, speed));
    scenes.push_back(corridor_of(name, std::make_shared<SceneActors>(actors)));
  }
  return scenes;
}

}  // namespace bw
