// Buildings that are corridors and nothing else: smooth walls, with the frames of closed doors here and
// there.
#include <algorithm>

#include "components/lab/bench/buildings/furniture.hpp"

namespace bw::buildings {
namespace {

/// Closed doors, set back a little, on both sides of the corridor from `a` to `b`; between one and the next
/// `least` to `most` [m].
void add_closed_doors(FloorPlan& plan, const Vector2& a, const Vector2& b, double width, double least,
                      double most, Random& random) {
  constexpr double kDoor = 0.95;
  const Vector2 along = (b - a).normalized();
  const Vector2 aside(-along.y(), along.x());
  for (const double side : {-1.0, 1.0}) {
    const double end = (b - a).norm() - width;
    for (double at = width + random.uniform(0.0, most); at < end; at += random.uniform(least, most)) {
      const Vector2 corner = a + at * along;
      const double depth = width / 2.0 + random.uniform(0.06, 0.15);
      plan.carve(corner, corner + kDoor * along + side * depth * aside);
    }
  }
}

}  // namespace

FloorPlan plan_corridors(Random& random) {
  FloorPlan plan;
  const double width = random.uniform(1.8, 2.4);
  const double length = random.uniform(60.0, 85.0);
  const double middle = random.uniform(10.0, 18.0);
  const double north = middle + random.uniform(10.0, 18.0);
  for (const double y : {0.0, middle, north}) {
    plan.carve_corridor({0.0, y}, {length, y}, width);
    add_closed_doors(plan, {0.0, y}, {length, y}, width, 8.0, 25.0, random);
  }
  for (const double x : {0.0, length}) plan.carve_corridor({x, 0.0}, {x, north}, width);
  // An arm that leads nowhere.
  const double arm = random.uniform(0.3, 0.7) * length;
  const double arm_end = -random.uniform(6.0, 12.0);
  plan.carve_corridor({arm, 0.0}, {arm, arm_end}, width);

  // An eight, then its lower half the other way round.
  plan.route = {{0.0, 0.0},       {arm, 0.0},    {arm, arm_end},   {arm, 0.0},      {length, 0.0},
                {length, middle}, {0.0, middle}, {0.0, north},     {length, north}, {length, 0.0},
                {0.0, 0.0},       {0.0, middle}, {length, middle}, {length, 0.0},   {0.7 * length, 0.0}};
  return plan;
}

FloorPlan plan_loop(Random& random) {
  FloorPlan plan;
  const double width = random.uniform(2.3, 3.0);
  const double half_round = 200.0 * random.uniform(0.97, 1.03);
  const double x = half_round * random.uniform(0.5, 0.7);
  const double y = half_round - x;
  const std::vector<Vector2> corners = {{0.0, 0.0}, {x, 0.0}, {x, y}, {0.0, y}};
  for (std::size_t i = 0; i < 4; ++i) {
    plan.carve_corridor(corners[i], corners[(i + 1) % 4], width);
    add_closed_doors(plan, corners[i], corners[(i + 1) % 4], width, 4.0, 12.0, random);
  }
  // Once round, on beyond the start, and back over it.
  const Vector2 start(random.uniform(0.3, 0.5) * x, 0.0);
  const Vector2 beyond = start + Vector2(random.uniform(20.0, 40.0), 0.0);
  plan.route = {start, corners[1], corners[2], corners[3], corners[0], start, beyond, {5.0, 0.0}};

  const Vector2 half = Vector2::Constant(width / 2.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector2& a = corners[i];
    const Vector2& b = corners[(i + 1) % 4];
    furnish(
        plan, {a.cwiseMin(b) - half, a.cwiseMax(b) + half},
        {.count = static_cast<int>((b - a).norm() / 8.0), .longest = 1.4, .deepest = 0.5, .along_walls = 1.0},
        random);
  }
  return plan;
}

}  // namespace bw::buildings
