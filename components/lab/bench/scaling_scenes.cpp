#include "components/lab/bench/scaling_scenes.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include "components/model/random.hpp"

namespace bw {
namespace {

constexpr double kLength = 12.0;                  // [m]
constexpr double kHalfWidth = 1.6;                // [m] of the corridor
constexpr double kRoughness = 0.02;               // [m] by which points lie before or behind the wall
constexpr double kHall = 50.0;                    // [m] half a side
constexpr double kFreeAtStart = 2.0;              // [m] around the robot
constexpr double kSlowest = 0.3, kFastest = 1.2;  // [m/s]

std::vector<Mover> walkers(Random& random, int count, double x_min, double x_max, double half_width) {
  std::vector<Mover> movers;
  while (static_cast<int>(movers.size()) < count) {
    Mover mover;
    mover.id = static_cast<std::uint32_t>(movers.size());
    mover.position.x() = random.uniform(x_min, x_max);
    mover.position.y() = random.uniform(-half_width, half_width);
    const double heading = random.uniform(-std::numbers::pi, std::numbers::pi);
    mover.velocity = random.uniform(kSlowest, kFastest) * direction(heading);
    if (mover.position.norm() > kFreeAtStart) movers.push_back(mover);
  }
  return movers;
}

}  // namespace

PlanningProblem crowded(Crowding crowding, int count, std::uint64_t seed) {
  Random random(seed);
  PlanningProblem problem;
  problem.now = Time::seconds(1.0);
  problem.plan = {{0.0, 0.0, 0.0}, {kLength, 0.0, 0.0}};
  const std::array<Vector2, 3> in_the_way{Vector2(3.0, random.uniform(-0.5, 0.5)),
                                          Vector2(6.0, random.uniform(-0.5, 0.5)),
                                          Vector2(9.0, random.uniform(-0.5, 0.5))};
  for (int i = 0; crowding == Crowding::points && i < count; ++i) {
    if (i < 3) {
      problem.obstacles.points.push_back(in_the_way[static_cast<std::size_t>(i)]);
      continue;
    }
    const double x = random.uniform(-1.0, kLength + 1.0);
    const double y = kHalfWidth + random.uniform(-kRoughness, kRoughness);
    problem.obstacles.points.push_back({x, i % 2 == 0 ? y : -y});
  }
  if (crowding == Crowding::corridor) {
    problem.obstacles.segments = {{{-1.0, kHalfWidth}, {kLength + 1.0, kHalfWidth}},
                                  {{-1.0, -kHalfWidth}, {kLength + 1.0, -kHalfWidth}}};
    problem.movers = walkers(random, count, 0.0, kLength, kHalfWidth - 0.3);
  } else if (crowding == Crowding::hall) {
    problem.movers = walkers(random, count, -kHall, kHall, kHall);
  }
  return problem;
}

}  // namespace bw
