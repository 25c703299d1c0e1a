#include "components/lab/bench/crowdnav_scene.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace bw {
namespace {

constexpr std::uint32_t kFirstTestSeed = 1000;
constexpr double kCircle = 4.0;                         // [m] radius
constexpr double kSquare = 10.0;                        // [m] side
constexpr double kApart = 2.0 * kCrowdNavRadius + 0.2;  // [m] between positions
constexpr std::size_t kFew = 5;

// CrowdNav++.
constexpr std::size_t kMany = 20;
constexpr std::uint32_t kCrowdSeed = 425;
constexpr double kArena = 6.0;                              // [m] half of the robot's square
constexpr double kArenaWay = 8.0;                           // [m] from its start to its goal, at least
constexpr double kCrowdCircle = 6.0 * std::numbers::sqrt2;  // [m] radius
constexpr double kOutwards = 2.0;     // [m] by which a start is moved along x and y, at most
constexpr double kCrowdApart = 0.25;  // [m] between outlines

bool is_near(const Vector2& position, const std::vector<Vector2>& taken) {
  return std::any_of(taken.begin(), taken.end(),
                     [&](const Vector2& other) { return (position - other).norm() < kApart; });
}

/// Positions that are taken.
struct TakenPositions {
  std::vector<Vector2> starts;
  std::vector<Vector2> goals;
};

CrowdNavPerson across_the_circle(CrowdNavRandom& random, const TakenPositions& taken) {
  while (true) {
    const double angle = 2.0 * std::numbers::pi * random.uniform();
    const double x = kCircle * std::cos(angle) + random.uniform() - 0.5;
    const double y = kCircle * std::sin(angle) + random.uniform() - 0.5;
    const Vector2 position(x, y);
    if (!is_near(position, taken.starts) && !is_near(position, taken.goals)) return {position, -position};
  }
}

Vector2 in_half(CrowdNavRandom& random, double sign, const std::vector<Vector2>& taken) {
  while (true) {
    const double x = 0.5 * kSquare * random.uniform() * sign;
    const double y = kSquare * (random.uniform() - 0.5);
    if (!is_near({x, y}, taken)) return {x, y};
  }
}

CrowdNavPerson across_the_square(CrowdNavRandom& random, const TakenPositions& taken) {
  const double sign = random.uniform() > 0.5 ? -1.0 : 1.0;
  const Vector2 start = in_half(random, sign, taken.starts);
  return {start, in_half(random, -sign, taken.goals)};
}

bool is_clear(const Vector2& position, double radius, const std::vector<CrowdNavPerson>& there) {
  return std::none_of(there.begin(), there.end(), [&](const CrowdNavPerson& other) {
    const double apart = radius + other.radius + kCrowdApart;
    return (position - other.start).norm() < apart || (position - other.goal).norm() < apart;
  });
}

// On the circle, moved by `first` to `first + width` along x and y.
Vector2 on_the_circle(CrowdNavRandom& random, double first, double width) {
  const double angle = 2.0 * std::numbers::pi * random.uniform();
  const double dx = first + width * random.uniform();
  const double dy = first + width * random.uniform();
  return {kCrowdCircle * std::cos(angle) + dx, kCrowdCircle * std::sin(angle) + dy};
}

CrowdNavScene crowd_scene(bool mixed, int test_case) {
  CrowdNavScene scene;
  scene.name = (mixed ? "mixed" : "crowd") + std::to_string(test_case);
  scene.rules = {.time_limit = 50.0,
                 .people_margin = 0.15,
                 .neighbours = kMany,
                 .sensed_range = 5.0,
                 .newcomers = true,
                 .mixed = mixed};
  scene.random = CrowdNavRandom(kFirstTestSeed + kCrowdSeed + static_cast<std::uint32_t>(test_case));
  do {
    double drawn[4];
    for (double& value : drawn) value = kArena * (2.0 * scene.random.uniform() - 1.0);
    scene.start = {drawn[0], drawn[1], 0.5 * std::numbers::pi};
    scene.goal = {drawn[2], drawn[3]};
  } while ((scene.goal - scene.start.position()).norm() < kArenaWay);
  std::vector<CrowdNavPerson> there{{scene.start.position(), scene.goal}};
  for (std::size_t i = 0; i < kMany; ++i) {
    scene.people.push_back(crowdnav_newcomer(scene.random, mixed, there));
    there.push_back(scene.people.back());
  }
  return scene;
}

}  // namespace

const char* to_text(CrowdNavCrossing crossing) {
  switch (crossing) {
    case CrowdNavCrossing::circle:
      return "circle";
    case CrowdNavCrossing::square:
      return "square";
    case CrowdNavCrossing::crowd:
      return "crowd";
    case CrowdNavCrossing::mixed_crowd:
      return "mixed_crowd";
  }
  return "";
}

CrowdNavPerson crowdnav_newcomer(CrowdNavRandom& random, bool mixed,
                                 const std::vector<CrowdNavPerson>& there) {
  CrowdNavPerson person;
  if (mixed) {
    person.look = 5.0 + 5.0 * random.uniform();
    person.speed = 0.5 + random.uniform();
    person.radius = 0.3 + 0.2 * random.uniform();
  }
  do person.start = on_the_circle(random, 0.0, kOutwards);
  while (!is_clear(person.start, person.radius, there));
  person.goal = -person.start;
  return person;
}

Vector2 crowdnav_other_goal(CrowdNavRandom& random, const CrowdNavPerson& self,
                            const std::vector<CrowdNavPerson>& others) {
  while (true) {
    const Vector2 goal = on_the_circle(random, -0.5 * self.speed, self.speed);
    if (is_clear(goal, self.radius, others)) return goal;
  }
}

CrowdNavScene crowdnav_scene(CrowdNavCrossing crossing, int test_case) {
  if (crossing == CrowdNavCrossing::crowd || crossing == CrowdNavCrossing::mixed_crowd)
    return crowd_scene(crossing == CrowdNavCrossing::mixed_crowd, test_case);
  const bool is_circle = crossing == CrowdNavCrossing::circle;
  CrowdNavScene scene;
  scene.people.resize(kFew);
  scene.name = (is_circle ? "circle" : "square") + std::to_string(test_case);
  CrowdNavRandom random(kFirstTestSeed + static_cast<std::uint32_t>(test_case));
  TakenPositions taken{{scene.start.position()}, {scene.goal}};
  for (CrowdNavPerson& person : scene.people) {
    person = is_circle ? across_the_circle(random, taken) : across_the_square(random, taken);
    taken.starts.push_back(person.start);
    taken.goals.push_back(person.goal);
  }
  return scene;
}

}  // namespace bw
