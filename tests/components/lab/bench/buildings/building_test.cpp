#include "components/lab/bench/buildings/building.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "components/lab/bench/buildings/floor_plan.hpp"
#include "components/model/nearest_point.hpp"
#include "components/world/ray.hpp"

namespace bw::buildings {
namespace {

constexpr std::uint64_t kSeeds = 20;

double length_of(const std::vector<Vector2>& corners, std::size_t first, std::size_t last) {
  double length = 0.0;
  for (std::size_t i = first; i < last; ++i) length += (corners[i + 1] - corners[i]).norm();
  return length;
}

/// Of two segments: that of one of the four ends, unless they cross.
double distance_between(const Segment& a, const Segment& b) {
  const Vector2 way = a.b - a.a;
  if (way.norm() > 0.0 && ray_hit(a.a, way.normalized(), b) <= way.norm()) return 0.0;
  const auto of = [](const Segment& s, const Vector2& p) { return (nearest_point(s, p) - p).norm(); };
  return std::min({of(a, b.a), of(a, b.b), of(b, a.a), of(b, a.b)});
}

template <class Check>
void for_all_buildings(const Check& check) {
  for (const BuildingKind kind : kBuildingKinds) {
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Building building = make_building(kind, seed);
      SCOPED_TRACE(building.name);
      check(kind, building);
    }
  }
}

// What building.hpp promises.
TEST(Buildings, RoutesKeepClearOfAllWalls) {
  for_all_buildings([](BuildingKind, const Building& building) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < building.route.size(); ++i) {
      for (const Segment& wall : building.walls)
        least = std::min(least, distance_between({building.route[i - 1], building.route[i]}, wall));
    }
    EXPECT_GE(least, kRouteClearance);
  });
}

TEST(Buildings, TheSameSeedGivesTheSameBuildingAndAnotherSeedAnother) {
  for_all_buildings([](BuildingKind kind, const Building& building) {
    const std::uint64_t seed = std::stoull(building.name.substr(building.name.find(' ')));
    const Building same = make_building(kind, seed);
    ASSERT_EQ(same.walls.size(), building.walls.size());
    for (std::size_t i = 0; i < same.walls.size(); ++i) {
      EXPECT_EQ(same.walls[i].a, building.walls[i].a);
      EXPECT_EQ(same.walls[i].b, building.walls[i].b);
    }
    EXPECT_EQ(same.route, building.route);
    EXPECT_NE(make_building(kind, seed + 1).route, building.route);
  });
}

// 8 + 7 + 7 + 8 (office_plan.cpp). A corner of the route within 2.3 m of a room's centre is in that room:
// half of the depth of the least, 4.6 m.
// Furniture moves, rooms and the route do not; and arrangement 0 is the office of that seed.
TEST(Buildings, AnOfficeIsFurnishedAnew) {
  const auto same = [](const Segment& a, const Segment& b) { return a.a == b.a && a.b == b.b; };
  const Building plain = make_building(BuildingKind::office, 3);
  const Building first = make_office(3, 0);
  const Building other = make_office(3, 1);
  EXPECT_TRUE(std::ranges::equal(plain.walls, first.walls, same));
  EXPECT_EQ(plain.route, other.route);
  EXPECT_EQ(plain.rooms, other.rooms);
  const auto stays = std::ranges::count_if(other.walls, [&](const Segment& wall) {
    return std::ranges::any_of(plain.walls, [&](const Segment& w) { return same(w, wall); });
  });
  EXPECT_GE(stays, 100) << "walls of 30 rooms with a door each";
  EXPECT_GE(static_cast<std::ptrdiff_t>(other.walls.size()) - stays, 4 * 60)
      << "30 rooms with three pieces or more, hardly one where it stood";
}

TEST(Buildings, AnOfficeHasThirtyRoomsAndTheRouteVisitsEach) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Building office = make_building(BuildingKind::office, seed);
    SCOPED_TRACE(office.name);
    EXPECT_EQ(office.rooms.size(), 30u);
    for (const Vector2& room : office.rooms) {
      EXPECT_TRUE(std::ranges::any_of(office.route,
                                      [&](const Vector2& corner) { return (corner - room).norm() < 2.3; }));
    }
  }
}

// 400 m was asked for; 5 % was allowed.
TEST(Buildings, TheLoopIsFourHundredMetresRound) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    const Building loop = make_building(BuildingKind::loop, seed);
    SCOPED_TRACE(loop.name);
    int circuits = 0;
    for (std::size_t i = 0; i < loop.route.size(); ++i) {
      for (std::size_t j = i + 1; j < loop.route.size(); ++j) {
        if ((loop.route[i] - loop.route[j]).norm() > 1e-6) continue;
        ++circuits;
        EXPECT_NEAR(length_of(loop.route, i, j), 400.0, 20.0);
      }
    }
    EXPECT_EQ(circuits, 1);
  }
}

// Two rectangles that overlap as an L: six borders, the perimeter of their bounding box.
TEST(FloorPlan, OutlineIsThatOfTheUnion) {
  FloorPlan plan;
  plan.carve({0.0, 0.0}, {6.0, 2.0});
  plan.carve({0.0, 4.0}, {2.0, 0.0});
  const std::vector<Segment> borders = outline(plan.free);
  EXPECT_EQ(borders.size(), 6u);
  double length = 0.0;
  for (const Segment& border : borders) length += (border.b - border.a).norm();
  EXPECT_NEAR(length, 2.0 * (6.0 + 4.0), 1e-12);
}

// A box of 2 x 1 m, turned by 90 degrees: from 3 m along x to its side half a metre from its centre.
TEST(FloorPlan, DistanceToABoxIsToItsNearestSide) {
  const StandingBox box{{1.0, 1.0, std::numbers::pi / 2.0}, {2.0, 1.0}};
  EXPECT_NEAR(distance_to(box, {4.0, 1.0}), 2.5, 1e-12);
  EXPECT_NEAR(distance_to(box, {1.5 + 3.0, 2.0 + 4.0}), 5.0, 1e-12);  // of the corner
  EXPECT_EQ(distance_to(box, {1.2, 0.2}), 0.0);
}

}  // namespace
}  // namespace bw::buildings
