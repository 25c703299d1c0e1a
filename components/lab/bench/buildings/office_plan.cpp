// Four rows of rooms: 8, 7, 7 and 8. Between the outer rows and the inner ones run two corridors, which
// corridors across join at both ends. The route goes round twice, the second time the other way, and into
// each room on one of these rounds.
//
//   row 3   | | | | | | | | |
//           =================
//   row 2   = | | | | | | | =
//   row 1   = | | | | | | | =
//           =================
//   row 0   | | | | | | | | |
#include <algorithm>
#include <array>

#include "components/lab/bench/buildings/furniture.hpp"

namespace bw::buildings {
namespace {

struct Door {
  Vector2 before;  ///< in the corridor [m]
  Vector2 behind;  ///< in the room, a metre from the door
  Rectangle room;
};

struct Row {
  double left, right;  ///< walls around it [m]
  double low, high;
  double corridor;  ///< y of the corridor's centre
  int rooms;
};

/// Cuts the row into rooms, each with a door to the corridor.
std::vector<Door> carve_row(FloorPlan& plan, const Row& row, Random& random) {
  std::vector<double> shares;
  double sum = 0.0;
  for (int i = 0; i < row.rooms; ++i) sum += shares.emplace_back(random.uniform(0.8, 1.25));
  const double width = row.right - row.left - (row.rooms - 1) * kWallThickness;
  const bool is_below = row.corridor > row.high;
  std::vector<Door> doors;
  double left = row.left;
  for (const double share : shares) {
    const double right = left + width * share / sum;
    const Rectangle room{{left, row.low}, {right, row.high}};
    const double x = random.uniform(left + 1.2, right - 1.2);
    const double edge = is_below ? row.high : row.low;
    const double half_width = random.uniform(0.5, 0.55);
    plan.carve(room.low, room.high);
    plan.carve({x - half_width, edge}, {x + half_width, row.corridor});
    plan.rooms.push_back(room);
    doors.push_back({{x, row.corridor}, {x, edge + (is_below ? -1.0 : 1.0)}, room});
    left = right + kWallThickness;
  }
  return doors;
}

/// In by the door, round a triangle, and out again.
void visit(FloorPlan& plan, const Door& door, Random& random) {
  constexpr double kFromWalls = 1.2;
  const double middle = door.room.center().y();
  const double far = middle + (middle - door.behind.y()) * random.uniform(0.3, 0.8);
  const double a = random.uniform(door.room.low.x() + kFromWalls, door.room.center().x() - 0.1);
  const double b = random.uniform(door.room.center().x() + 0.1, door.room.high.x() - kFromWalls);
  const bool starts_left = random.uniform() < 0.5;
  for (const Vector2& place : {door.before, door.behind, Vector2(starts_left ? a : b, far),
                               Vector2(starts_left ? b : a, far), door.behind, door.before})
    plan.route.push_back(place);
}

/// Rooms of one corridor in the order of its direction.
void visit_all(FloorPlan& plan, std::vector<Door> doors, bool eastwards, Random& random) {
  std::ranges::stable_sort(doors, {},
                           [&](const Door& d) { return eastwards ? d.before.x() : -d.before.x(); });
  for (const Door& door : doors) visit(plan, door, random);
}

}  // namespace

FloorPlan plan_office(Random& random, std::uint64_t arrangement) {
  FloorPlan plan;
  const double corridor = random.uniform(2.0, 2.6);
  const double length = 8.0 * random.uniform(3.9, 4.8);
  std::array<double, 4> low{}, high{};
  double y = 0.0;
  for (std::size_t i = 0; i < 4; ++i) {
    low[i] = y;
    high[i] = y + random.uniform(4.6, 6.2);
    y = high[i] + kWallThickness + (i == 1 ? 0.0 : corridor + kWallThickness);
  }
  const double south = high[0] + kWallThickness + corridor / 2.0;
  const double north = high[2] + kWallThickness + corridor / 2.0;
  const double west = corridor / 2.0;
  const double east = length - corridor / 2.0;
  plan.carve_corridor({west, south}, {east, south}, corridor);
  plan.carve_corridor({west, north}, {east, north}, corridor);
  plan.carve_corridor({west, south}, {west, north}, corridor);
  plan.carve_corridor({east, south}, {east, north}, corridor);

  // [round][corridor]
  std::array<std::array<std::vector<Door>, 2>, 2> doors;
  for (std::size_t i = 0; i < 4; ++i) {
    const bool is_inner = i == 1 || i == 2;
    const double inset = is_inner ? corridor + kWallThickness : 0.0;
    const Row row{inset, length - inset, low[i], high[i], i < 2 ? south : north, is_inner ? 7 : 8};
    for (const Door& door : carve_row(plan, row, random))
      doors[random.uniform() < 0.5 ? 0 : 1][i < 2 ? 0 : 1].push_back(door);
  }
  plan.route = {{west, south}};
  visit_all(plan, doors[0][0], true, random);
  plan.route.insert(plan.route.end(), {{east, south}, {east, north}});
  visit_all(plan, doors[0][1], false, random);
  plan.route.insert(plan.route.end(), {{west, north}, {west, south}, {west, north}});
  visit_all(plan, doors[1][1], true, random);
  plan.route.insert(plan.route.end(), {{east, north}, {east, south}});
  visit_all(plan, doors[1][0], false, random);
  plan.route.emplace_back(west, south);

  const auto furnish_all = [&](Random& draws) {
    for (const Rectangle& room : std::vector(plan.rooms))
      furnish(plan, room, {.count = static_cast<int>(draws.uniform(3.0, 8.0))}, draws);
    for (const double at : {south, north}) {
      const Vector2 half(length / 2.0, corridor / 2.0);
      const Vector2 center(length / 2.0, at);
      furnish(plan, {center - half, center + half},
              {.count = 6, .longest = 1.2, .deepest = 0.45, .along_walls = 1.0}, draws);
    }
  };
  furnish_all(random);
  if (arrangement > 0) {
    plan.boxes.clear();
    Random other(arrangement * 0xbf58476d1ce4e5b9);
    furnish_all(other);
  }
  return plan;
}

// Ten corridors one above the other, 20 m apart, between two that join their ends; on either side of each a row of 24
// rooms. The route goes through all, to and fro, into every eighth room, back to the first and through it again.
FloorPlan plan_campus(Random& random) {
  constexpr double kSide = 200.0;
  constexpr int kCorridors = 10;
  constexpr int kRooms = 24;
  constexpr double kCorridor = 2.4;
  constexpr double kPitch = kSide / kCorridors;
  FloorPlan plan;
  const double west = kCorridor / 2.0;
  const double east = kSide - kCorridor / 2.0;
  const double north = kSide - kPitch / 2.0;
  for (const double x : {west, east}) plan.carve_corridor({x, kPitch / 2.0}, {x, north}, kCorridor);
  for (int k = 0; k < kCorridors; ++k) {
    const double y = (k + 0.5) * kPitch;
    const double depth = (kPitch - kCorridor - 3.0 * kWallThickness) / 2.0;
    const double edge = kCorridor / 2.0 + kWallThickness;
    const double inset = kCorridor + kWallThickness;
    const bool eastwards = k % 2 == 0;
    plan.carve_corridor({west, y}, {east, y}, kCorridor);
    std::vector<Door> doors;
    for (const double low : {y - edge - depth, y + edge}) {
      const std::vector<Door> row =
          carve_row(plan, {inset, kSide - inset, low, low + depth, y, kRooms}, random);
      for (std::size_t i = 0; i < row.size(); i += 8) doors.push_back(row[i]);
    }
    plan.route.emplace_back(eastwards ? west : east, y);
    visit_all(plan, doors, eastwards, random);
    plan.route.emplace_back(eastwards ? east : west, y);
  }
  for (const double x : {west, east}) plan.route.emplace_back(x, kPitch / 2.0);
  for (const Rectangle& room : std::vector(plan.rooms)) furnish(plan, room, {.count = 6}, random);
  for (int k = 0; k < kCorridors; ++k) {
    const Vector2 half(kSide / 2.0, kCorridor / 2.0);
    const Vector2 center(kSide / 2.0, (k + 0.5) * kPitch);
    furnish(plan, {center - half, center + half},
            {.count = 30, .longest = 1.2, .deepest = 0.45, .along_walls = 1.0}, random);
  }
  return plan;
}

}  // namespace bw::buildings
