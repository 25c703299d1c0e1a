#include "components/lab/bench/buildings/wall_index.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "components/lab/bench/buildings/building.hpp"
#include "components/model/nearest_point.hpp"
#include "components/model/random.hpp"
#include "components/world/ray.hpp"

namespace bw::buildings {
namespace {

// Against a look at every wall.
TEST(WallIndex, IsEqualToASearchThroughAllWalls) {
  for (const BuildingKind kind : kBuildingKinds) {
    const Building building = make_building(kind, 3);
    SCOPED_TRACE(building.name);
    const WallIndex index(building.walls);
    Random random(7);
    for (int i = 0; i < 2000; ++i) {
      const auto leg =
          static_cast<std::size_t>(random.uniform() * static_cast<double>(building.route.size() - 1));
      const Vector2 origin =
          building.route[leg] + random.uniform() * (building.route[leg + 1] - building.route[leg]);
      const Vector2 looks = direction(random.uniform(-std::numbers::pi, std::numbers::pi));
      const double limit = random.uniform(1.0, 40.0);
      double hit = kNoHit;
      double nearest = limit;
      for (const Segment& wall : building.walls) {
        hit = std::min(hit, ray_hit(origin, looks, wall));
        nearest = std::min(nearest, (nearest_point(wall, origin) - origin).norm());
      }
      EXPECT_EQ(index.ray_hit(origin, looks, limit), hit < limit ? hit : kNoHit);
      EXPECT_EQ(index.clearance(origin, limit), nearest);
    }
  }
}

// A wall across the axis at 7 m, of which the ends are at 5 m to either side.
TEST(WallIndex, MeetsWhatIsOnAnAxisAndNothingBeyondTheLimit) {
  const WallIndex index({{{7.0, -5.0}, {7.0, 5.0}}, {{0.0, -5.0}, {0.0, 5.0}}});
  EXPECT_EQ(index.ray_hit({2.0, 0.0}, {1.0, 0.0}, 30.0), 5.0);
  EXPECT_EQ(index.ray_hit({2.0, 0.0}, {-1.0, 0.0}, 30.0), 2.0);
  EXPECT_EQ(index.ray_hit({2.0, 0.0}, {0.0, 1.0}, 30.0), kNoHit);
  EXPECT_EQ(index.ray_hit({2.0, 0.0}, {1.0, 0.0}, 4.9), kNoHit);
  EXPECT_EQ(index.clearance({2.0, 0.0}, 30.0), 2.0);
  EXPECT_EQ(WallIndex({}).ray_hit({0.0, 0.0}, {1.0, 0.0}, 30.0), kNoHit);
}

}  // namespace
}  // namespace bw::buildings
