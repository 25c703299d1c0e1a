// Buildings that are one hall: pillars at the nodes of a lattice, or shelves with aisles between them.
#include <array>

#include "components/lab/bench/buildings/furniture.hpp"

namespace bw::buildings {
namespace {

int drawn_count(Random& random, int least, int most) {
  return least + static_cast<int>(random.uniform(0.0, most - least + 1.0));
}

/// A bay between two frames, of which a laser sees the posts, and what is stored in it.
void add_bay(FloorPlan& plan, const Rectangle& bay, Random& random) {
  constexpr double kPost = 0.1;
  for (const double x : {bay.low.x(), bay.high.x() - kPost}) {
    for (const double y : {bay.low.y(), bay.high.y() - kPost})
      plan.boxes.push_back({{x + kPost / 2.0, y + kPost / 2.0, 0.0}, {kPost, kPost}});
  }
  const Vector2 size(random.uniform(1.0, 2.3), random.uniform(0.7, 1.0));
  const Vector2 shift(random.uniform(-0.1, 0.1), random.uniform(-0.05, 0.05));
  if (random.uniform() < 0.25) return;  // empty
  const Vector2 place = bay.center() + shift;
  plan.boxes.push_back({{place.x(), place.y(), 0.0}, size});
}

}  // namespace

FloorPlan plan_pillars(Random& random) {
  FloorPlan plan;
  const int columns = drawn_count(random, 6, 8);
  const int rows = drawn_count(random, 4, 6);
  const Vector2 spacing(random.uniform(4.5, 6.0), random.uniform(4.5, 6.0));
  const double side = random.uniform(0.35, 0.7);
  const auto lane = [&](int column, int row) {
    return Vector2((column + 0.5) * spacing.x(), (row + 0.5) * spacing.y());
  };
  plan.carve({0.0, 0.0}, {columns * spacing.x(), rows * spacing.y()});
  for (int i = 1; i < columns; ++i) {
    for (int j = 1; j < rows; ++j)
      plan.boxes.push_back({{i * spacing.x(), j * spacing.y(), 0.0}, {side, side}});
  }
  // To and fro along one axis, then along the other, and home by the first lane, against its direction.
  for (int i = 0; i < columns; ++i) {
    plan.route.push_back(lane(i, i % 2 == 0 ? 0 : rows - 1));
    plan.route.push_back(lane(i, i % 2 == 0 ? rows - 1 : 0));
  }
  const bool ends_high = columns % 2 == 1;
  for (int k = 0; k < rows; ++k) {
    const int j = ends_high ? rows - 1 - k : k;
    if (k > 0) plan.route.push_back(lane(k % 2 == 0 ? columns - 1 : 0, j));
    plan.route.push_back(lane(k % 2 == 0 ? 0 : columns - 1, j));
  }
  const int last_row = ends_high ? 0 : rows - 1;
  if (rows % 2 == 0) plan.route.push_back(lane(0, last_row));
  if (last_row > 0) {
    plan.route.push_back(lane(0, 0));
  } else {
    plan.route.insert(plan.route.end(), {lane(0, rows - 1), lane(0, 0)});
  }
  return plan;
}

FloorPlan plan_warehouse(Random& random) {
  FloorPlan plan;
  const int shelves = drawn_count(random, 5, 6);
  const std::array<int, 2> bays = {drawn_count(random, 4, 6), drawn_count(random, 4, 6)};
  const double aisle = random.uniform(2.2, 2.8);
  const double across = random.uniform(2.6, 3.4);  // width of the aisles at the ends and in the middle
  constexpr double kBay = 2.7, kDepth = 1.1;
  const double middle = across + bays[0] * kBay + across / 2.0;
  const double length = 3.0 * across + (bays[0] + bays[1]) * kBay;
  const auto y_of = [&](int i) { return aisle / 2.0 + i * (aisle + kDepth); };  // of an aisle's centre
  plan.carve({0.0, 0.0}, {length, y_of(shelves) + aisle / 2.0});
  for (int i = 0; i < shelves; ++i) {
    for (std::size_t block = 0; block < 2; ++block) {
      const double first = block == 0 ? across : middle + across / 2.0;
      for (int k = 0; k < bays[block]; ++k) {
        const Vector2 low(first + k * kBay, y_of(i) + aisle / 2.0);
        add_bay(plan, {low, low + Vector2(kBay, kDepth)}, random);
      }
    }
  }
  const double west = across / 2.0;
  const double east = length - across / 2.0;
  // All aisles to and fro; then by the middle back to the first of them, half of it the other way, and every
  // second aisle of the first block.
  for (int i = 0; i <= shelves; ++i) {
    plan.route.emplace_back(i % 2 == 0 ? west : east, y_of(i));
    plan.route.emplace_back(i % 2 == 0 ? east : west, y_of(i));
  }
  plan.route.insert(plan.route.end(), {{middle, y_of(shelves)}, {middle, y_of(0)}});
  for (int i = 0; i <= shelves; i += 2) {
    const bool outwards = i % 4 == 0;
    if (i > 0) plan.route.emplace_back(outwards ? middle : west, y_of(i));
    plan.route.emplace_back(outwards ? west : middle, y_of(i));
  }
  return plan;
}

}  // namespace bw::buildings
