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

}  // namespace

CrowdNavScene crowdnav_scene(CrowdNavCrossing crossing, int test_case) {
  const bool is_circle = crossing == CrowdNavCrossing::circle;
  CrowdNavScene scene;
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
